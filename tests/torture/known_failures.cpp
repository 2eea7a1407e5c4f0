// SPDX-License-Identifier: MIT
#include "torture/known_failures.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "torture/scene.h"

namespace torture {

Failures failures_of(const oracle::Metrics& metrics) {
    return {metrics.missed, metrics.phantom, metrics.moved, metrics.gave_up};
}

std::size_t allowance(std::size_t recorded) { return std::max<std::size_t>(2, recorded / 20); }

bool is_worse(const Failures& now, const Failures& recorded) {
    const auto above = [](std::size_t number, std::size_t known) {
        return number > known + allowance(known);
    };
    return above(now.missed, recorded.missed) || above(now.phantom, recorded.phantom) ||
           above(now.moved, recorded.moved) || above(now.unresolved, recorded.unresolved);
}

bool is_better(const Failures& now, const Failures& recorded) {
    const std::size_t wrong_now = now.missed + now.phantom + now.moved;
    const std::size_t wrong_then = recorded.missed + recorded.phantom + recorded.moved;
    return wrong_now + allowance(wrong_then) < wrong_then;
}

Failures shrunk(const Failures& now, const Failures& recorded) {
    return {std::min(now.missed, recorded.missed), std::min(now.phantom, recorded.phantom),
            std::min(now.moved, recorded.moved), std::min(now.unresolved, recorded.unresolved)};
}

base::Result<Records> read_records(const std::filesystem::path& path) {
    constexpr std::size_t largest = 1 << 24;
    const auto text = base::read_text(path, largest);
    if (!text) return text.problems();
    const auto json = nlohmann::json::parse(*text, nullptr, false);
    if (json.is_discarded()) return base::error(path.string() + " is no JSON");
    Records records;
    for (const auto& [name, scene] : json.at("scenes").items()) {
        SceneRecord& record = records[name];
        const auto& reference = scene.at("reference");
        record = {reference.at("compared"), reference.at("undecided"), reference.at("fragile"), {}};
        for (const auto& [tracer, numbers] : scene.at("tracers").items()) {
            record.tracers[tracer] = {numbers.at("missed"), numbers.at("phantom"),
                                      numbers.at("moved"), numbers.at("unresolved")};
        }
    }
    return records;
}

std::string records_text(const Records& records) {
    std::string text = fmt::format("{{\n  \"size\": [{}, {}],\n  \"scenes\": {{", width, height);
    const char* scene_end = "\n";
    for (const auto& [name, record] : records) {
        text += fmt::format(
            "{}    \"{}\": {{\n"
            "      \"reference\": {{\"compared\": {}, \"undecided\": {}, \"fragile\": {}}},\n"
            "      \"tracers\": {{",
            scene_end, name, record.compared, record.undecided, record.fragile);
        const char* tracer_end = "\n";
        for (const auto& [tracer, failures] : record.tracers) {
            text += fmt::format(
                "{}        \"{}\": {{\"missed\": {}, \"phantom\": {}, \"moved\": {}, "
                "\"unresolved\": {}}}",
                tracer_end, tracer, failures.missed, failures.phantom, failures.moved,
                failures.unresolved);
            tracer_end = ",\n";
        }
        text += "\n      }\n    }";
        scene_end = ",\n";
    }
    return text + "\n  }\n}\n";
}

}  // namespace torture
