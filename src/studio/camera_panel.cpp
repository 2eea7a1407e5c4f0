// SPDX-License-Identifier: MIT
// The camera as numbers, and what the document says about itself.
#include <imgui.h>
#include <imgui_stdlib.h>
#include <glm/geometric.hpp>

#include "studio/actions.h"
#include "studio/panels.h"
#include "studio/slider.h"

namespace studio {
namespace {

void show_numbers(Workspace& workspace) {
    scene::Camera camera = workspace.camera();
    const double speed = 0.005 * (1e-6 + glm::distance(camera.eye, camera.target));
    bool changed = vector_field("Eye", camera.eye, speed);
    changed |= vector_field("Target", camera.target, speed);
    glm::dvec3 up = camera.up;
    if (vector_field("Up", up, 0.01) && glm::length(up) > 0) {
        camera.up = up;
        changed = true;
    }
    changed |= slider("Field of view", camera.fov,
                      {.minimum = 1, .maximum = 150, .initial = 45, .format = "%.1f deg"},
                      "The full vertical angle.");
    if (changed && camera.eye != camera.target) workspace.document.camera = camera;
}

}  // namespace

void show_camera_panel(Workspace& workspace) {
    show_numbers(workspace);
    ImGui::Spacing();
    if (ImGui::Button("Frame all (F)")) {
        frame_all(workspace);
    }
    ImGui::SameLine();
    if (ImGui::Button("Default view")) workspace.document.camera.reset();
    tooltip_of_last("Looks at the whole region from the front, right and above.");
    ImGui::Spacing();
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled(
        "On the picture: drag to turn, right- or middle-drag to move, wheel to come nearer.");
    ImGui::PopTextWrapPos();
}

void show_document_panel(Workspace& workspace) {
    scene::Document& document = workspace.document;
    label_on_the_left("Title");
    ImGui::InputText("##title", &document.title, ImGuiInputTextFlags_NoUndoRedo);
    ImGui::TextUnformatted("Description");
    ImGui::InputTextMultiline("##description", &document.description,
                              ImVec2(-1, 7 * ImGui::GetTextLineHeight()),
                              ImGuiInputTextFlags_NoUndoRedo);
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("%s", workspace.file ? workspace.file->c_str() : "not saved yet");
    ImGui::PopTextWrapPos();
}

}  // namespace studio
