// SPDX-License-Identifier: MIT
#include "studio/layout.h"

#include <algorithm>

#include <imgui.h>

#include "studio/panels.h"

namespace studio {
namespace {

struct Box {
    float x = 0, y = 0, width = 0, height = 0;
};

constexpr ImGuiWindowFlags fixed_window = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                          ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                          ImGuiWindowFlags_NoSavedSettings |
                                          ImGuiWindowFlags_NoBringToFrontOnFocus;

bool begin_fixed(const char* name, const Box& box, ImGuiWindowFlags flags = 0) {
    ImGui::SetNextWindowPos(ImVec2(box.x, box.y));
    ImGui::SetNextWindowSize(ImVec2(box.width, box.height));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    const bool shown = ImGui::Begin(name, nullptr, fixed_window | flags);
    ImGui::PopStyleVar();
    return shown;
}

/// A thin bar that is dragged; answers by how much.
float splitter(const char* name, const Box& box, bool vertical) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
    begin_fixed(name, box, ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleVar(2);
    ImGui::InvisibleButton("bar", ImVec2(box.width, box.height));
    const bool hot = ImGui::IsItemHovered() || ImGui::IsItemActive();
    if (hot) {
        ImGui::SetMouseCursor(vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    }
    const ImU32 colour = ImGui::GetColorU32(hot ? ImGuiCol_SeparatorHovered : ImGuiCol_Separator);
    ImGui::GetWindowDrawList()->AddRectFilled(
        ImVec2(box.x, box.y), ImVec2(box.x + box.width, box.y + box.height), colour);
    const ImVec2 delta = ImGui::IsItemActive() ? ImGui::GetIO().MouseDelta : ImVec2(0, 0);
    ImGui::End();
    return vertical ? delta.x : delta.y;
}

/// Tabs that are narrow enough to stand all side by side.
void push_tab_style(float scale) {
    const ImGuiStyle& style = ImGui::GetStyle();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(5 * scale, style.FramePadding.y));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemInnerSpacing,
                        ImVec2(3 * scale, style.ItemInnerSpacing.y));
}

void show_tab(const char* name, Workspace& workspace, void (*panel)(Workspace&)) {
    push_tab_style(workspace.scale);
    const bool open = ImGui::BeginTabItem(name);
    ImGui::PopStyleVar(2);
    if (!open) return;
    ImGui::BeginChild("content");
    ImGui::Spacing();
    panel(workspace);
    ImGui::EndChild();
    ImGui::EndTabItem();
}

void show_tabs(Workspace& workspace) {
    push_tab_style(workspace.scale);
    const bool open = ImGui::BeginTabBar("tabs", ImGuiTabBarFlags_FittingPolicyResizeDown);
    ImGui::PopStyleVar(2);
    if (!open) return;
    show_tab("Sliders", workspace, show_parameter_panel);
    show_tab("Render", workspace, show_render_panel);
    show_tab("Light", workspace, show_light_panel);
    show_tab("Material", workspace, show_material_panel);
    show_tab("Camera", workspace, show_camera_panel);
    show_tab("About", workspace, show_document_panel);
    ImGui::EndTabBar();
}

/// The left column; what remains of the box is left of it.
void show_left_column(Workspace& workspace, Box& box) {
    View& view = workspace.view;
    const float bar = 3 * workspace.scale;
    const float width = std::clamp(view.left_width * workspace.scale, 200.0f, box.width * 0.6f);
    const float height =
        std::clamp(view.formula_height * workspace.scale, 90.0f, box.height * 0.8f);
    begin_fixed("Formula", {box.x, box.y, width, height});
    show_formula_panel(workspace);
    ImGui::End();
    view.formula_height +=
        splitter("split formula", {box.x, box.y + height, width, bar}, false) / workspace.scale;
    begin_fixed("Tabs", {box.x, box.y + height + bar, width, box.height - height - bar});
    show_tabs(workspace);
    ImGui::End();
    view.left_width +=
        splitter("split left", {box.x + width, box.y, bar, box.height}, true) / workspace.scale;
    view.left_width = std::max(view.left_width, 200.0f);
    view.formula_height = std::max(view.formula_height, 90.0f);
    box.x += width + bar;
    box.width -= width + bar;
}

/// Presets above, accuracy below, or one of them alone.
void show_right_column(Workspace& workspace, Box& box) {
    View& view = workspace.view;
    const float bar = 3 * workspace.scale;
    float& wanted = view.accuracy ? view.accuracy_width : view.right_width;
    const float width = std::clamp(wanted * workspace.scale, 120.0f, box.width * 0.6f);
    const float left = box.x + box.width - width;
    float top = box.y;
    if (view.presets) {
        const float below = std::clamp(view.accuracy_height * workspace.scale, 90.0f,
                                       std::max(90.0f, box.height - 90.0f));
        const float height = view.accuracy ? box.height - below : box.height;
        begin_fixed("Presets", {left, top, width, height});
        show_preset_panel(workspace);
        ImGui::End();
        top += height;
    }
    if (view.presets && view.accuracy) {
        view.accuracy_height -=
            splitter("split accuracy", {left, top, width, bar}, false) / workspace.scale;
        view.accuracy_height = std::max(view.accuracy_height, 90.0f);
        top += bar;
    }
    if (view.accuracy) {
        begin_fixed("Accuracy", {left, top, width, box.y + box.height - top});
        show_accuracy_panel(workspace);
        ImGui::End();
    }
    wanted -= splitter("split right", {left - bar, box.y, bar, box.height}, true) / workspace.scale;
    wanted = std::max(wanted, 120.0f);
    box.width -= width + bar;
}

/// Messages stand on the picture, at its bottom.
void show_message_area(Workspace& workspace, const Box& box) {
    if (!has_messages_to_show(workspace)) return;
    const float margin = 10 * workspace.scale;
    ImGui::SetNextWindowPos(ImVec2(box.x + margin, box.y + box.height - margin), ImGuiCond_Always,
                            ImVec2(0, 1));
    ImGui::SetNextWindowSize(ImVec2(std::min(box.width - 2 * margin, 560 * workspace.scale), 0));
    ImGui::SetNextWindowBgAlpha(0.85f);
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                       ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                       ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;
    ImGui::Begin("Newest messages", nullptr, flags);
    show_messages(workspace);
    ImGui::End();
}

}  // namespace

void show_interface(Workspace& workspace) {
    show_menu_bar(workspace);
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    Box box{viewport.WorkPos.x, viewport.WorkPos.y, viewport.WorkSize.x, viewport.WorkSize.y};
    const float status = ImGui::GetFrameHeight() + 6 * workspace.scale;
    box.height -= status;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(10 * workspace.scale, 2));
    begin_fixed("Status", {box.x, box.y + box.height, box.width, status},
                ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleVar();
    show_status_bar(workspace);
    ImGui::End();

    if (workspace.view.panels) {
        show_left_column(workspace, box);
        if (workspace.view.presets || workspace.view.accuracy) show_right_column(workspace, box);
    }
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    begin_fixed("Picture", box, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar();
    show_picture(workspace);
    ImGui::End();

    show_message_area(workspace, box);
    show_log(workspace);
    show_help(workspace);
    show_dialogs(workspace);
}

}  // namespace studio
