// SPDX-License-Identifier: MIT
// The table of materials.
#include <optional>

#include <fmt/format.h>
#include <imgui.h>

#include "render/frame.h"
#include "studio/panels.h"
#include "studio/slider.h"

namespace studio {
namespace {

void show_number(const char* id, double& value, const SliderRange& range) {
    ImGui::SetNextItemWidth(-1);
    ImGui::SliderScalar(
        id, ImGuiDataType_Double, &value, &range.minimum, &range.maximum, range.format,
        ImGuiSliderFlags_AlwaysClamp | (range.logarithmic ? ImGuiSliderFlags_Logarithmic : 0));
}

/// One row; true if the user wants to remove it.
bool show_material(scene::Material& material, std::size_t number, bool removable) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::Text("%zu", number);
    ImGui::TableNextColumn();
    ImGui::SetNextItemWidth(-1);
    colour_field("##colour", material.colour, scene::Material{}.colour);
    ImGui::TableNextColumn();
    show_number("##specular", material.specular, {.minimum = 0, .maximum = 2, .format = "%.2f"});
    ImGui::TableNextColumn();
    show_number("##shininess", material.shininess,
                {.minimum = 1, .maximum = 1000, .logarithmic = true, .format = "%.0f"});
    ImGui::TableNextColumn();
    ImGui::BeginDisabled(!removable);
    const bool removed = ImGui::Button("x");
    ImGui::EndDisabled();
    tooltip_of_last("Remove this material");
    return removed;
}

}  // namespace

void show_material_panel(Workspace& workspace) {
    auto& materials = workspace.document.materials;
    std::optional<std::size_t> removed;
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_SizingStretchProp;
    if (ImGui::BeginTable("materials", 5, flags)) {
        const float narrow = ImGui::GetFrameHeight();
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, narrow * 0.7f);
        ImGui::TableSetupColumn("Colour", ImGuiTableColumnFlags_WidthStretch, 1.5f);
        ImGui::TableSetupColumn("Specular", ImGuiTableColumnFlags_WidthStretch, 1);
        ImGui::TableSetupColumn("Shininess", ImGuiTableColumnFlags_WidthStretch, 1);
        ImGui::TableSetupColumn("##remove", ImGuiTableColumnFlags_WidthFixed, narrow);
        ImGui::TableHeadersRow();
        for (std::size_t i = 0; i < materials.size(); ++i) {
            ImGui::PushID(static_cast<int>(i));
            if (show_material(materials[i], i + 1, materials.size() > 1)) removed = i;
            ImGui::PopID();
        }
        ImGui::EndTable();
    }
    if (removed) materials.erase(materials.begin() + static_cast<std::ptrdiff_t>(*removed));
    ImGui::BeginDisabled(materials.size() >= render::max_materials);
    if (ImGui::Button("Add a material")) materials.emplace_back();
    ImGui::EndDisabled();
    ImGui::Spacing();
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled(
        "The objects of the scene, from left to right in the formula, take the materials in turn.");
    ImGui::PopTextWrapPos();
}

}  // namespace studio
