// SPDX-License-Identifier: MIT
#include "scene/preset_parameters.h"

#include "scene/preset_object.h"

namespace scene {
namespace {

using Kind = Json::Kind;

constexpr std::string_view expected =
    "a number, a list of 2 to 4 numbers, text in quotes, true or false";

std::optional<ParameterValue> read_vector(const Json& json, const Place& place, Reading& reading) {
    const std::size_t size = json.elements.size();
    if (size < 2 || size > 4) {
        reading.expect(json, place, expected);
        return std::nullopt;
    }
    std::vector<double> components(size);
    bool fine = true;
    for (std::size_t i = 0; i < size; ++i) {
        fine &= read_value(json.elements[i], any_number, place.element(i), reading, components[i]);
    }
    if (!fine) return std::nullopt;
    return components;
}

std::optional<ParameterValue> read_parameter(const Json& json, const Place& place,
                                             Reading& reading) {
    switch (json.kind) {
        case Kind::boolean:
            return json.truth;
        case Kind::text:
            return json.text;
        case Kind::list:
            return read_vector(json, place, reading);
        case Kind::number: {
            double value = 0;
            if (read_value(json, any_number, place, reading, value)) return value;
            return std::nullopt;
        }
        case Kind::null:
        case Kind::object:
            break;
    }
    reading.expect(json, place, expected);
    return std::nullopt;
}

/// The value as JSON, if JSON can hold it.
struct Writer {
    std::optional<Json> operator()(double value) const {
        if (!is_writable(value)) return std::nullopt;
        return Json::of(value);
    }
    std::optional<Json> operator()(const std::vector<double>& components) const {
        std::vector<Json> elements;
        for (const double component : components) {
            if (!is_writable(component)) return std::nullopt;
            elements.push_back(Json::of(component));
        }
        return Json::of(std::move(elements));
    }
    std::optional<Json> operator()(const std::string& label) const { return Json::of(label); }
    std::optional<Json> operator()(bool on) const { return Json::of(on); }
};

}  // namespace

void read_parameters(const Json& json, const Place& place, Reading& reading, Document& document) {
    if (json.kind != Kind::object) {
        reading.expect(json, place, "an object");
        return;
    }
    reading.reject_duplicates(json, place);
    for (const JsonMember& member : json.members) {
        auto value = read_parameter(member.value, place.member(member.key), reading);
        if (!value) continue;
        document.parameters[member.key] = *std::move(value);
        reading.parameter_places[member.key] = {member.key_span, member.value.span};
    }
}

std::optional<Json> write_parameters(const Document& document, bool) {
    Json json = Json::object();
    for (const auto& [name, value] : document.parameters) {
        if (auto written = std::visit(Writer{}, value)) json.add(name, *std::move(written));
    }
    if (json.members.empty()) return std::nullopt;
    return json;
}

}  // namespace scene
