// SPDX-License-Identifier: MIT
// Lights as a list, and the light from everywhere.
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>
#include <imgui.h>
#include <glm/geometric.hpp>

#include "render/frame.h"
#include "studio/panels.h"
#include "studio/slider.h"

namespace studio {
namespace {

constexpr double degrees = 180 / std::numbers::pi;

/// A direction as angles in degrees: azimuth around +y from +z, elevation above the ground.
struct Angles {
    double azimuth = 0, elevation = 0;
};

Angles angles_of(const glm::dvec3& direction) {
    const double flat = std::hypot(direction.x, direction.z);
    return {std::atan2(direction.x, direction.z) * degrees,
            std::atan2(direction.y, flat) * degrees};
}

glm::dvec3 direction_of(const Angles& angles) {
    const double azimuth = angles.azimuth / degrees, elevation = angles.elevation / degrees;
    return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
            std::cos(elevation) * std::cos(azimuth)};
}

void show_light(scene::Light& light) {
    const scene::Light fresh;
    const Angles initial = angles_of(fresh.direction);
    Angles angles = angles_of(light.direction);
    const bool turned =
        slider("Azimuth", angles.azimuth,
               {.minimum = -180, .maximum = 180, .initial = initial.azimuth, .format = "%.0f deg"});
    const bool raised = slider(
        "Elevation", angles.elevation,
        // Straight up would forget the azimuth.
        {.minimum = -89.9, .maximum = 89.9, .initial = initial.elevation, .format = "%.0f deg"});
    if (turned || raised) light.direction = direction_of(angles);
    colour_field("Colour", light.colour, fresh.colour);
    slider("Intensity", light.intensity, {.minimum = 0, .maximum = 4, .initial = fresh.intensity});
}

void show_lights(std::vector<scene::Light>& lights) {
    std::optional<std::size_t> removed;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        bool kept = true;
        const std::string title = fmt::format("Light {}###light", i + 1);
        if (ImGui::CollapsingHeader(title.c_str(), &kept, ImGuiTreeNodeFlags_DefaultOpen)) {
            show_light(lights[i]);
        }
        if (!kept) removed = i;
        ImGui::PopID();
    }
    if (removed) lights.erase(lights.begin() + static_cast<std::ptrdiff_t>(*removed));
    ImGui::BeginDisabled(lights.size() >= render::max_lights);
    if (ImGui::Button("Add a light")) {
        scene::Light light;
        light.direction = direction_of({-60 + 55.0 * static_cast<double>(lights.size()), 35});
        light.intensity = 0.5;
        lights.push_back(light);
    }
    ImGui::EndDisabled();
}

void show_environment(scene::Environment& environment) {
    const scene::Environment initial;
    colour_field("Sky light", environment.sky, initial.sky);
    colour_field("Ground light", environment.ground, initial.ground);
    colour_field("Backdrop top", environment.background_top, initial.background_top);
    colour_field("Backdrop bottom", environment.background_bottom, initial.background_bottom);
}

}  // namespace

void show_light_panel(Workspace& workspace) {
    show_lights(workspace.document.lights);
    ImGui::Spacing();
    if (ImGui::CollapsingHeader("Light from everywhere", ImGuiTreeNodeFlags_DefaultOpen)) {
        show_environment(workspace.document.environment);
    }
}

}  // namespace studio
