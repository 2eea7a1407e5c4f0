// SPDX-License-Identifier: MIT
// Reading and writing of an object by its table of fields.
#pragma once

#include <cmath>

#include <fmt/format.h>

#include "scene/preset_reading.h"

namespace scene {

inline bool is_writable(double value) { return std::isfinite(value); }
inline bool is_writable(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
inline bool is_writable(const std::string&) { return true; }

inline Json to_json(bool value) { return Json::of(value); }
inline Json to_json(int value) { return Json::of(static_cast<double>(value)); }
inline Json to_json(double value) { return Json::of(value); }
inline Json to_json(const std::string& value) { return Json::of(value); }
inline Json to_json(const glm::dvec3& v) {
    return Json::of(std::vector<Json>{Json::of(v.x), Json::of(v.y), Json::of(v.z)});
}

/// Reads an object's fields into a value that holds the defaults. False if there was a problem;
/// unknown fields are kept.
template <class Owner, class Fields>
bool read_object(const Json& json, const Fields& fields, const Place& place, Reading& reading,
                 Owner& owner) {
    if (json.kind != Json::Kind::object) {
        reading.expect(json, place, "an object");
        return false;
    }
    const std::size_t problems_before = reading.problems.size();
    reading.reject_duplicates(json, place);
    std::vector<std::string> known;
    for (const auto& field : fields) known.emplace_back(field.name);
    for (const JsonMember& member : json.members) {
        const Place here = place.member(member.key);
        bool found = false;
        for (const auto& field : fields) {
            if (field.name != member.key) continue;
            found = true;
            std::visit(
                [&](auto at) { read_value(member.value, field.range, here, reading, owner.*at); },
                field.member);
        }
        if (!found) reading.keep_unknown(member, here, known);
    }
    for (const auto& field : fields) {
        if (!field.required || json.find(field.name)) continue;
        reading.fail(json, fmt::format("'{}' needs the field '{}'", place.name, field.name));
    }
    return reading.problems.size() == problems_before;
}

/// The object's fields that differ from the defaults. What is not finite is left out.
template <class Owner, class Fields>
Json write_object(const Owner& owner, const Fields& fields) {
    const Owner defaults;
    Json json = Json::object();
    for (const auto& field : fields) {
        std::visit(
            [&](auto at) {
                const bool differs = field.required || owner.*at != defaults.*at;
                if (differs && is_writable(owner.*at)) {
                    json.add(std::string(field.name), to_json(owner.*at));
                }
            },
            field.member);
    }
    return json;
}

}  // namespace scene
