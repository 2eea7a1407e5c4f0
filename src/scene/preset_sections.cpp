// SPDX-License-Identifier: MIT
// The table of a preset's parts, and those parts that have no file of their own.
#include "scene/preset_sections.h"

#include <array>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "scene/preset_bounds.h"
#include "scene/preset_formula.h"
#include "scene/preset_object.h"
#include "scene/preset_parameters.h"

namespace scene {
namespace {

using Kind = Json::Kind;

template <auto member>
void read_text_field(const Json& json, const Place& place, Reading& reading, Document& document) {
    read_value(json, {}, place, reading, document.*member);
}

template <auto member>
std::optional<Json> write_text_field(const Document& document, bool) {
    if ((document.*member).empty()) return std::nullopt;
    return Json::of(document.*member);
}

void read_time(const Json& json, const Place& place, Reading& reading, Document& document) {
    read_value(json, any_number, place, reading, document.time);
}

std::optional<Json> write_time(const Document& document, bool) {
    if (document.time == 0 || !is_writable(document.time)) return std::nullopt;
    return Json::of(document.time);
}

void read_camera(const Json& json, const Place& place, Reading& reading, Document& document) {
    Camera camera;
    if (!read_object(json, camera_fields, place, reading, camera)) return;
    const double size = 1 + glm::length(camera.eye) + glm::length(camera.target);
    if (glm::length(camera.eye - camera.target) < 1e-13 * size) {
        reading.fail(*json.find("eye"),
                     "'camera.eye' and 'camera.target' must be two points apart");
    } else if (glm::length(camera.up) < 1e-9) {
        reading.fail(*json.find("up"), "'camera.up' must be a direction, not [0, 0, 0]");
    } else {
        document.camera = camera;
    }
}

std::optional<Json> write_camera(const Document& document, bool) {
    if (!document.camera || !is_writable(document.camera->eye) ||
        !is_writable(document.camera->target)) {
        return std::nullopt;
    }
    return write_object(*document.camera, camera_fields);
}

/// A list of objects of which there may be `least` to `most`.
template <class Owner, class Fields>
std::vector<Owner> read_list(const Json& json, const Fields& fields, const Place& place,
                             Reading& reading, std::size_t least, std::size_t most) {
    if (json.kind != Kind::list || json.elements.size() < least || json.elements.size() > most) {
        reading.expect(json, place, fmt::format("a list of {} to {} objects", least, most));
        return std::vector<Owner>(1);
    }
    std::vector<Owner> list(json.elements.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
        read_object(json.elements[i], fields, place.element(i), reading, list[i]);
    }
    return list;
}

template <class Owner, class Fields>
std::optional<Json> write_list(const std::vector<Owner>& list, const Fields& fields,
                               bool asked_for) {
    if (list == std::vector<Owner>(1) && !asked_for) return std::nullopt;
    std::vector<Json> elements;
    for (const Owner& owner : list) elements.push_back(write_object(owner, fields));
    return Json::of(std::move(elements));
}

void read_lights(const Json& json, const Place& place, Reading& reading, Document& document) {
    document.lights = read_list<Light>(json, light_fields, place, reading, 0, most_lights);
    for (std::size_t i = 0; i < document.lights.size(); ++i) {
        if (glm::length(document.lights[i].direction) >= 1e-9) continue;
        reading.fail(*json.elements[i].find("direction"),
                     fmt::format("'lights[{}].direction' must be a direction, not [0, 0, 0]", i));
    }
}

std::optional<Json> write_lights(const Document& document, bool asked_for) {
    return write_list(document.lights, light_fields, asked_for);
}

void read_materials(const Json& json, const Place& place, Reading& reading, Document& document) {
    document.materials =
        read_list<Material>(json, material_fields, place, reading, 1, most_materials);
}

std::optional<Json> write_materials(const Document& document, bool asked_for) {
    return write_list(document.materials, material_fields, asked_for);
}

template <auto member, const auto& fields>
void read_part(const Json& json, const Place& place, Reading& reading, Document& document) {
    read_object(json, fields, place, reading, document.*member);
}

template <auto member, const auto& fields>
std::optional<Json> write_part(const Document& document, bool asked_for) {
    Json json = write_object(document.*member, fields);
    if (json.members.empty() && !asked_for) return std::nullopt;
    return json;
}

constexpr std::array table{
    Section{"title", read_text_field<&Document::title>, write_text_field<&Document::title>},
    Section{"description", read_text_field<&Document::description>,
            write_text_field<&Document::description>},
    Section{"formula", read_formula, write_formula},
    Section{"parameters", read_parameters, write_parameters},
    Section{"time", read_time, write_time},
    Section{"bounds", read_bounds, write_bounds},
    Section{"camera", read_camera, write_camera},
    Section{"lights", read_lights, write_lights},
    Section{"materials", read_materials, write_materials},
    Section{"environment", read_part<&Document::environment, environment_fields>,
            write_part<&Document::environment, environment_fields>},
    Section{"settings", read_part<&Document::settings, settings_fields>,
            write_part<&Document::settings, settings_fields>},
};

}  // namespace

std::span<const Section> sections() { return table; }

}  // namespace scene
