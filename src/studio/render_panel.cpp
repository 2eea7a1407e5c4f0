// SPDX-License-Identifier: MIT
// How the picture is made: tracer, precision, effects, and the region that is looked at.
#include <string>

#include <imgui.h>
#include <glm/common.hpp>

#include "shader/program_source.h"
#include "studio/panels.h"
#include "studio/slider.h"

namespace studio {
namespace {

void show_tracer(scene::Settings& settings) {
    label_on_the_left("Tracer");
    if (ImGui::BeginCombo("##tracer", settings.tracer.c_str())) {
        for (const shader::TracerName& tracer : shader::tracers()) {
            const std::string name(tracer.name);
            if (ImGui::Selectable(name.c_str(), name == settings.tracer)) settings.tracer = name;
            tooltip_of_last(std::string(tracer.summary));
        }
        ImGui::EndCombo();
    }
    tooltip_of_last("How a ray finds the surface. 'auto' chooses for the formula at hand.");
}

void show_numbers(scene::Settings& settings) {
    label_on_the_left("Numbers");
    if (ImGui::BeginCombo("##precision", settings.precision.c_str())) {
        for (const char* name : {"auto", "single", "double"}) {
            if (ImGui::Selectable(name, name == settings.precision)) settings.precision = name;
        }
        ImGui::EndCombo();
    }
    tooltip_of_last(
        "In which precision the picture is calculated. 'auto' takes double where single is not "
        "sharp; the status bar says which.");
}

void show_precision(scene::Settings& settings) {
    const scene::Settings initial;
    slider("Lipschitz scale", settings.lipschitz,
           {.minimum = 0.1, .maximum = 10, .initial = initial.lipschitz, .logarithmic = true},
           "Every step is divided by it: above 1 is slower and safer, below 1 faster and bolder.");
    slider("Steps at most", settings.steps,
           {.minimum = 16, .maximum = 4096, .initial = double(initial.steps), .logarithmic = true},
           "Rays that need more are given up; the status bar counts them.");
    slider("Epsilon", settings.epsilon,
           {.minimum = 0.001, .maximum = 10, .initial = initial.epsilon, .logarithmic = true},
           "A hit is closer than this part of a pixel's footprint.");
    slider("Exposure", settings.exposure,
           {.minimum = 0.05, .maximum = 20, .initial = initial.exposure, .logarithmic = true},
           "Brightness of the whole picture.");
}

void show_effects(scene::Settings& settings) {
    const scene::Settings initial;
    check("Shadows", settings.shadows);
    ImGui::BeginDisabled(!settings.shadows);
    slider("Shadow factor", settings.shadow,
           {.minimum = 1, .maximum = 128, .initial = initial.shadow, .logarithmic = true},
           "Small is soft, large is hard.");
    ImGui::EndDisabled();
    check("Ambient occlusion (not drawn yet)", settings.ambient_occlusion,
          "Darkens corners. The switch is kept in the preset for the effect to come.");
    check("Ground grid", settings.grid);
    check("Show step count", settings.show_steps,
          "Colours each pixel by the number of steps of its ray instead of shading it.");
    check("Show what is proven", settings.show_certificate,
          "Colours each pixel by what its ray proves: a hit light grey, a miss dark blue, a hit "
          "within rounding yellow, a hit by guessed steps orange, a miss by such brown, out of "
          "steps magenta.");
}

void show_bounds_shape(scene::Bounds& bounds) {
    using Shape = scene::Bounds::Shape;
    static constexpr const char* names[] = {"sphere", "box", "none"};
    int shape = static_cast<int>(bounds.shape);
    label_on_the_left("Shape");
    if (!ImGui::Combo("##shape", &shape, names, 3)) return;
    bounds.shape = static_cast<Shape>(shape);
    if (bounds.shape == Shape::sphere) bounds.half = glm::dvec3(bounds.half.x);
}

void show_bounds(scene::Bounds& bounds) {
    constexpr double smallest = 1e-6, largest = 1e6;
    show_bounds_shape(bounds);
    switch (bounds.shape) {
        case scene::Bounds::Shape::sphere: {
            double radius = bounds.half.x;
            if (number_field("Radius", radius, 0.01, smallest, largest)) {
                bounds.half = glm::dvec3(radius);
            }
            break;
        }
        case scene::Bounds::Shape::box: {
            glm::dvec3 half = bounds.half;
            if (vector_field("Half size", half, 0.01)) {
                bounds.half = glm::clamp(half, smallest, largest);
            }
            break;
        }
        case scene::Bounds::Shape::none:
            return;
    }
    vector_field("Centre", bounds.centre, 0.01);
}

}  // namespace

void show_render_panel(Workspace& workspace) {
    scene::Document& document = workspace.document;
    show_tracer(document.settings);
    show_numbers(document.settings);
    show_precision(document.settings);
    if (ImGui::CollapsingHeader("Effects", ImGuiTreeNodeFlags_DefaultOpen)) {
        show_effects(document.settings);
    }
    if (ImGui::CollapsingHeader("Region that is looked at", ImGuiTreeNodeFlags_DefaultOpen)) {
        show_bounds(document.bounds);
    }
    ImGui::Spacing();
    if (ImGui::Button("All settings to their defaults")) document.settings = {};
}

}  // namespace studio
