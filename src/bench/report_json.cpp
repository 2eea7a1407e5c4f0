// SPDX-License-Identifier: MIT
#include "bench/report_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr int version = 1;

Json json(const Machine& m) {
    return {{"processor", m.processor}, {"cores", m.cores},
            {"backend", m.backend},     {"renderer", m.renderer},
            {"version", m.version},     {"date", m.date},
            {"commit", m.commit},       {"shader_cache", m.shader_cache}};
}

Machine machine(const Json& j) {
    Machine m;
    j.at("processor").get_to(m.processor);
    j.at("cores").get_to(m.cores);
    j.at("backend").get_to(m.backend);
    j.at("renderer").get_to(m.renderer);
    j.at("version").get_to(m.version);
    j.at("date").get_to(m.date);
    j.at("commit").get_to(m.commit);
    j.at("shader_cache").get_to(m.shader_cache);
    return m;
}

Json json(const Errors& e) {
    return {{"compared", e.compared},
            {"undecided", e.undecided},
            {"fragile", e.fragile},
            {"missed", e.missed},
            {"phantom", e.phantom},
            {"moved", e.moved},
            {"depth", {e.depth_median, e.depth_99, e.depth_largest}},
            {"normal", {e.normal_median, e.normal_99}}};
}

Errors errors(const Json& j) {
    Errors e;
    j.at("compared").get_to(e.compared);
    j.at("undecided").get_to(e.undecided);
    j.at("fragile").get_to(e.fragile);
    j.at("missed").get_to(e.missed);
    j.at("phantom").get_to(e.phantom);
    j.at("moved").get_to(e.moved);
    j.at("depth").at(0).get_to(e.depth_median);
    j.at("depth").at(1).get_to(e.depth_99);
    j.at("depth").at(2).get_to(e.depth_largest);
    j.at("normal").at(0).get_to(e.normal_median);
    j.at("normal").at(1).get_to(e.normal_99);
    return e;
}

Json json(const Entry& e) {
    Json j{{"tracer", e.tracer}};
    if (!e.move.name.empty()) j["move"] = {{"setting", e.move.name}, {"value", e.move.value}};
    j["seconds"] = e.seconds;
    j["link_seconds"] = e.link_seconds;
    j["first_frame_seconds"] = e.first_frame_seconds;
    if (e.evaluations) j["evaluations"] = *e.evaluations;
    j["pixels"] = {{"hit", e.hit}, {"miss", e.miss}, {"unresolved", e.unresolved}};
    if (e.errors) j["errors"] = json(*e.errors);
    if (e.passes) {
        j["passes"] = {{"geometry", e.passes->geometry},
                       {"normal", e.passes->normal},
                       {"shading", e.passes->shading},
                       {"shadows", e.passes->shadows}};
    }
    return j;
}

Entry entry(const Json& j) {
    Entry e;
    j.at("tracer").get_to(e.tracer);
    if (j.contains("move")) {
        e.move = {j["move"].at("setting").get<std::string>(), j["move"].at("value").get<double>()};
    }
    j.at("seconds").get_to(e.seconds);
    j.at("link_seconds").get_to(e.link_seconds);
    j.at("first_frame_seconds").get_to(e.first_frame_seconds);
    if (j.contains("evaluations")) e.evaluations = j["evaluations"].get<double>();
    j.at("pixels").at("hit").get_to(e.hit);
    j.at("pixels").at("miss").get_to(e.miss);
    j.at("pixels").at("unresolved").get_to(e.unresolved);
    if (j.contains("errors")) e.errors = errors(j["errors"]);
    if (j.contains("passes")) {
        const Json& p = j["passes"];
        e.passes = {p.at("geometry").get<double>(), p.at("normal").get<double>(),
                    p.at("shading").get<double>(), p.at("shadows").get<double>()};
    }
    return e;
}

Json json(const PresetReport& p) {
    Json j{{"preset", p.preset},
           {"smooth", p.smooth},
           {"proven", p.proven},
           {"yardstick_seconds", p.yardstick_seconds},
           {"settings", p.settings},
           {"parse_seconds", p.parse_seconds},
           {"analyse_seconds", p.analyse_seconds},
           {"entries", Json::array()}};
    for (const Entry& e : p.entries) j["entries"].push_back(json(e));
    if (p.slider) {
        j["slider"] = {{"before_seconds", p.slider->before_seconds},
                       {"picture_seconds", p.slider->picture_seconds},
                       {"coarse", p.slider->coarse}};
    }
    return j;
}

PresetReport preset(const Json& j) {
    PresetReport p;
    j.at("preset").get_to(p.preset);
    j.at("smooth").get_to(p.smooth);
    j.at("proven").get_to(p.proven);
    j.at("yardstick_seconds").get_to(p.yardstick_seconds);
    j.at("settings").get_to(p.settings);
    p.parse_seconds = j.value("parse_seconds", 0.0);
    p.analyse_seconds = j.value("analyse_seconds", 0.0);
    for (const Json& e : j.at("entries")) p.entries.push_back(entry(e));
    if (j.contains("slider")) {
        const Json& s = j["slider"];
        p.slider = {s.at("before_seconds").get<double>(), s.at("picture_seconds").get<double>(),
                    s.at("coarse").get<bool>()};
    }
    return p;
}

Report report(const Json& j) {
    Report r;
    r.machine = machine(j.at("machine"));
    j.at("size").at(0).get_to(r.width);
    j.at("size").at(1).get_to(r.height);
    j.at("reference_size").at(0).get_to(r.reference_width);
    j.at("reference_size").at(1).get_to(r.reference_height);
    j.at("rounds").get_to(r.rounds);
    j.at("command").get_to(r.command);
    for (const Json& p : j.at("presets")) r.presets.push_back(preset(p));
    return r;
}

}  // namespace

std::string report_json(const Report& r) {
    Json j{
        {"zeroset_bench", version},    {"machine", json(r.machine)},
        {"size", {r.width, r.height}}, {"reference_size", {r.reference_width, r.reference_height}},
        {"rounds", r.rounds},          {"command", r.command},
        {"presets", Json::array()}};
    for (const PresetReport& p : r.presets) j["presets"].push_back(json(p));
    return j.dump(1) + '\n';
}

base::Result<Report> read_report(std::string_view text, const std::string& name) {
    try {
        const Json j = Json::parse(text);
        if (j.at("zeroset_bench") == version) return report(j);
        return base::error(fmt::format(
            "'{}' is a report of another version; make it again with 'zeroset bench --json'",
            name));
    } catch (const Json::exception&) {
        return base::error(
            fmt::format("'{}' is no report; make one with 'zeroset bench --json'", name));
    }
}

}  // namespace bench
