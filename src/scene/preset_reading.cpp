// SPDX-License-Identifier: MIT
// Reading of a preset's single values, and the texts of what can be wrong with them.
#include "scene/preset_reading.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "scene/near_name.h"
#include "scene/utf8.h"

namespace scene {
namespace {

using Kind = Json::Kind;

/// The beginning of a text, cut between two characters.
std::string shortened(std::string_view text) {
    constexpr std::size_t longest = 30;
    std::size_t at = 0;
    while (at < text.size() && at < longest) at += std::max<std::size_t>(1, utf8_length(text, at));
    return std::string(text.substr(0, at)) + (at < text.size() ? "..." : "");
}

std::string describe(const Json& json) {
    switch (json.kind) {
        case Kind::null:
            return "null";
        case Kind::boolean:
            return json.truth ? "true" : "false";
        case Kind::number:
            return shortened(json.text);
        case Kind::text:
            return print_json_compact(Json::of(shortened(json.text)));
        case Kind::list:
            return json.elements.empty() ? "an empty list"
                                         : fmt::format("a list of {}", json.elements.size());
        case Kind::object:
            return "an object";
    }
    return {};
}

std::string with_range(std::string_view what, Range range) {
    if (range.least == any_number.least) return std::string(what);
    return fmt::format("{} from {} to {}", what, range.least, range.greatest);
}

bool holds(Range range, double value) { return value >= range.least && value <= range.greatest; }

}  // namespace

Place Place::member(std::string_view key) const {
    std::string token;
    for (char c : key) {
        if (c == '~') {
            token += "~0";
        } else if (c == '/') {
            token += "~1";
        } else {
            token += c;
        }
    }
    return {name.empty() ? std::string(key) : fmt::format("{}.{}", name, key),
            pointer + '/' + token};
}

Place Place::element(std::size_t index) const {
    return {fmt::format("{}[{}]", name, index), fmt::format("{}/{}", pointer, index)};
}

void Reading::fail(const Json& at, std::string message) {
    problems.push_back(base::error(at.span, std::move(message)));
}

void Reading::expect(const Json& at, const Place& place, std::string_view expected) {
    fail(at, fmt::format("'{}' must be {}, not {}", place.name, expected, describe(at)));
}

void Reading::keep_unknown(const JsonMember& member, const Place& place,
                           const std::vector<std::string>& known) {
    unknown[place.pointer] = print_json_compact(member.value);
    std::string message = fmt::format("unknown field '{}' is kept but ignored", place.name);
    const std::string meant = near_name(member.key, known);
    if (!meant.empty()) message += fmt::format("; did you mean '{}'?", meant);
    warnings.push_back(base::warning(member.key_span, std::move(message)));
}

void Reading::reject_duplicates(const Json& object, const Place& place) {
    for (const JsonMember& member : object.members) {
        if (object.find(member.key) == &member.value) continue;
        problems.push_back(
            base::error(member.key_span, fmt::format("the field '{}' stands here a second time; "
                                                     "keep one of them",
                                                     place.member(member.key).name)));
    }
}

bool read_value(const Json& json, Range, const Place& place, Reading& reading, bool& value) {
    if (json.kind != Kind::boolean) {
        reading.expect(json, place, "true or false");
        return false;
    }
    value = json.truth;
    return true;
}

bool read_value(const Json& json, Range range, const Place& place, Reading& reading, int& value) {
    const bool fine = json.kind == Kind::number && holds(range, json.number) &&
                      json.number == std::floor(json.number);
    if (!fine) {
        reading.expect(json, place, with_range("a whole number", range));
        return false;
    }
    value = static_cast<int>(json.number);
    return true;
}

bool read_value(const Json& json, Range range, const Place& place, Reading& reading,
                double& value) {
    if (json.kind != Kind::number || !holds(range, json.number)) {
        reading.expect(json, place, with_range("a number", range));
        return false;
    }
    value = json.number;
    return true;
}

bool read_value(const Json& json, Range, const Place& place, Reading& reading, std::string& value) {
    if (json.kind != Kind::text) {
        reading.expect(json, place, "text in quotes");
        return false;
    }
    value = json.text;
    return true;
}

bool read_value(const Json& json, Range range, const Place& place, Reading& reading,
                glm::dvec3& value) {
    if (json.kind != Kind::list || json.elements.size() != 3) {
        reading.expect(json, place, "a list of 3 numbers");
        return false;
    }
    glm::dvec3 components;
    bool fine = true;
    for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        fine &= read_value(json.elements[k], range, place.element(k), reading, components[i]);
    }
    if (fine) value = components;
    return fine;
}

std::vector<double> read_numbers(const Json& json, const Place& place, Reading& reading,
                                 std::string_view expected, std::size_t length,
                                 std::size_t other_length,
                                 Range (*range)(std::size_t, std::size_t)) {
    const std::size_t size = json.elements.size();
    if (json.kind != Kind::list || (size != length && size != other_length)) {
        reading.expect(json, place, expected);
        return {};
    }
    std::vector<double> numbers(size);
    bool fine = true;
    for (std::size_t i = 0; i < size; ++i) {
        fine &= read_value(json.elements[i], range(i, size), place.element(i), reading, numbers[i]);
    }
    return fine ? numbers : std::vector<double>{};
}

}  // namespace scene
