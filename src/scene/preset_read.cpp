// SPDX-License-Identifier: MIT
// From a preset's text to a document.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "scene/json.h"
#include "scene/preset.h"
#include "scene/preset_migrate.h"
#include "scene/preset_reading.h"
#include "scene/preset_sections.h"

namespace scene {
namespace {

using Kind = Json::Kind;

base::Result<int> read_version(const Json& json) {
    if (json.kind != Kind::object) {
        return base::error(json.span, "this is not a Zeroset preset: it must begin with '{'");
    }
    const base::SourceSpan opening{json.span.begin, json.span.begin + 1};
    const Json* version = json.find("zeroset");
    if (!version) {
        return base::error(opening, fmt::format("this is not a Zeroset preset: the field 'zeroset' "
                                                "with its version is missing; add \"zeroset\": {}",
                                                preset_version));
    }
    const bool whole = version->kind == Kind::number && version->number >= 1 &&
                       version->number == std::floor(version->number);
    if (!whole) {
        return base::error(
            version->span,
            fmt::format("'zeroset' must be the version of the preset, a whole number "
                        "from 1 to {}, not {}",
                        preset_version, print_json_compact(*version)));
    }
    if (version->number > preset_version) {
        return base::error(version->span,
                           fmt::format("this preset was written by a newer Zeroset (version {}); "
                                       "this one reads up to {}",
                                       version->text, preset_version));
    }
    return static_cast<int>(version->number);
}

/// Problems in the order of their places.
void sort(base::Diagnostics& diagnostics) {
    std::stable_sort(diagnostics.begin(), diagnostics.end(),
                     [](const auto& a, const auto& b) { return a.span->begin < b.span->begin; });
}

}  // namespace

base::Result<Preset> read_preset(std::string_view text) {
    base::Result<Json> parsed = parse_json(text);
    if (!parsed) return parsed.problems();
    const base::Result<int> version = read_version(*parsed);
    if (!version) return version.problems();
    const Json json = migrate(*std::move(parsed), *version);

    Reading reading;
    reading.text = text;
    Preset preset;
    const Place root;
    reading.reject_duplicates(json, root);
    std::vector<std::string> known{"zeroset"};
    for (const Section& section : sections()) known.emplace_back(section.name);
    for (const JsonMember& member : json.members) {
        const Place place = root.member(member.key);
        const auto section = std::find_if(sections().begin(), sections().end(),
                                          [&](const Section& s) { return s.name == member.key; });
        if (section != sections().end()) {
            section->read(member.value, place, reading, preset.document);
        } else if (member.key != "zeroset") {
            reading.keep_unknown(member, place, known);
        }
    }
    if (!json.find("formula")) {
        reading.problems.push_back(
            base::error({json.span.begin, json.span.begin + 1},
                        "the formula is missing; add a field 'formula', such as "
                        "\"formula\": \"x^2 + y^2 + z^2 = 1\""));
    }
    if (!reading.problems.empty()) {
        sort(reading.problems);
        return std::move(reading.problems);
    }
    sort(reading.warnings);
    preset.document.unknown = std::move(reading.unknown);
    preset.warnings = std::move(reading.warnings);
    preset.formula_places = std::move(reading.formula_places);
    preset.parameter_places = std::move(reading.parameter_places);
    return preset;
}

}  // namespace scene
