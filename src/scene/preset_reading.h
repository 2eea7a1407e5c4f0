// SPDX-License-Identifier: MIT
// What the readers of a preset's parts share: where they are, and what they have found.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "scene/json.h"
#include "scene/preset_fields.h"

namespace scene {

/// A value's place in a preset, for people ("lights[0].colour") and for machines
/// ("/lights/0/colour").
struct Place {
    std::string name;
    std::string pointer;

    Place member(std::string_view key) const;
    Place element(std::size_t index) const;
};

/// Everything that comes out of reading a preset besides the document's own members.
struct Reading {
    std::string_view text;
    base::Diagnostics problems;
    base::Diagnostics warnings;
    std::map<std::string, std::string> unknown;
    std::vector<std::uint32_t> formula_places;
    ParameterPlaces parameter_places;

    void fail(const Json& at, std::string message);
    /// "'settings.steps' must be EXPECTED, not WHAT STANDS THERE"
    void expect(const Json& at, const Place& place, std::string_view expected);
    void keep_unknown(const JsonMember& member, const Place& place,
                      const std::vector<std::string>& known);
    void reject_duplicates(const Json& object, const Place& place);
};

/// Read one value of a type; on a problem report it and leave `value` as it is.
bool read_value(const Json& json, Range range, const Place& place, Reading& reading, bool& value);
bool read_value(const Json& json, Range range, const Place& place, Reading& reading, int& value);
bool read_value(const Json& json, Range range, const Place& place, Reading& reading, double& value);
bool read_value(const Json& json, Range range, const Place& place, Reading& reading,
                std::string& value);
bool read_value(const Json& json, Range range, const Place& place, Reading& reading,
                glm::dvec3& value);

/// A list of finite numbers of one of two lengths (empty on a problem); `range` is of the element
/// with the given index.
std::vector<double> read_numbers(const Json& json, const Place& place, Reading& reading,
                                 std::string_view expected, std::size_t length,
                                 std::size_t other_length,
                                 Range (*range)(std::size_t, std::size_t));

}  // namespace scene
