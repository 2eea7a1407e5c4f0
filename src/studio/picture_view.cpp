// SPDX-License-Identifier: MIT
// The picture on the screen, and the camera by mouse on it.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include <imgui.h>

#include "studio/camera_control.h"
#include "studio/overlay_colours.h"
#include "studio/panels.h"

namespace studio {
namespace {

constexpr float least_mark = 3;
constexpr int mark_alpha = 230;
constexpr std::uint64_t wheel_gesture = 3;  // of the same pause-limited kind as typing

ImTextureID texture(GLuint name) {
    return reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(name));
}

/// The base stretched over the whole area, then the tiles of the full picture.
void draw_layers(const PictureLayers& layers, ImVec2 corner, ImVec2 size) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (layers.base != 0) {
        list.AddImage(texture(layers.base), corner, ImVec2(corner.x + size.x, corner.y + size.y));
    }
    if (layers.full == 0 || !layers.tiles) return;
    const auto width = static_cast<float>(layers.width);
    const auto height = static_cast<float>(layers.height);
    for (const render::Tile& tile : *layers.tiles) {
        const ImVec2 from(static_cast<float>(tile.x) / width, static_cast<float>(tile.y) / height);
        const ImVec2 to(static_cast<float>(tile.x + tile.width) / width,
                        static_cast<float>(tile.y + tile.height) / height);
        list.AddImage(texture(layers.full),
                      ImVec2(corner.x + from.x * size.x, corner.y + from.y * size.y),
                      ImVec2(corner.x + to.x * size.x, corner.y + to.y * size.y), from, to);
    }
}

/// Marks of at least a few pixels, so that single ones can be seen.
void draw_overlay(const Workspace& workspace, ImVec2 corner, ImVec2 size) {
    const Accuracy& accuracy = workspace.accuracy;
    const Judged* judged = accuracy.judged();
    if (!judged || !accuracy.overlay || !workspace.view.accuracy) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float across = size.x / static_cast<float>(accuracy.reference->width);
    const float down = size.y / static_cast<float>(accuracy.reference->height);
    const float more_x = std::max(0.0f, (least_mark * workspace.scale - across) / 2);
    const float more_y = std::max(0.0f, (least_mark * workspace.scale - down) / 2);
    for (const MarkedArea& area : judged->areas) {
        const float x = corner.x + static_cast<float>(area.x) * across;
        const float y = corner.y + static_cast<float>(area.y) * down;
        list.AddRectFilled(ImVec2(x - more_x, y - more_y),
                           ImVec2(x + static_cast<float>(area.width) * across + more_x,
                                  y + static_cast<float>(area.height) * down + more_y),
                           overlay_colour(area.judgement, mark_alpha));
    }
}

/// Left turns; right, middle or Shift+left moves; the wheel comes nearer.
void move_camera(Workspace& workspace, double height) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool left = ImGui::IsMouseDown(ImGuiMouseButton_Left);
    const bool pans = !left || io.KeyShift;
    const bool moved = io.MouseDelta.x != 0 || io.MouseDelta.y != 0;
    if (ImGui::IsItemActive() && moved) {
        const scene::Camera camera = workspace.camera();
        workspace.document.camera =
            pans ? drag_pan(camera, io.MouseDelta.x, io.MouseDelta.y, height)
                 : drag_orbit(camera, io.MouseDelta.x, io.MouseDelta.y, height);
    }
    if (ImGui::IsItemHovered() && io.MouseWheel != 0) {
        workspace.document.camera = wheel_dolly(workspace.camera(), io.MouseWheel);
        workspace.gesture = wheel_gesture;
    }
}

}  // namespace

void show_picture(Workspace& workspace) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size = ImGui::GetContentRegionAvail();
    if (size.x < 1 || size.y < 1) return;
    const ImVec2 pixels = ImGui::GetIO().DisplayFramebufferScale;
    workspace.area.width = static_cast<int>(std::lround(size.x * pixels.x));
    workspace.area.height = static_cast<int>(std::lround(size.y * pixels.y));
    ImGui::InvisibleButton("picture", size,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    move_camera(workspace, size.y);
    draw_layers(workspace.layers, corner, size);
    draw_overlay(workspace, corner, size);
    const PictureLayers& layers = workspace.layers;
    if (layers.base != 0 || (layers.tiles && !layers.tiles->empty())) return;
    const char* text = workspace.compilation.busy ? "compiling..." : "no picture yet";
    const ImVec2 extent = ImGui::CalcTextSize(text);
    ImGui::GetWindowDrawList()->AddText(
        ImVec2(corner.x + (size.x - extent.x) / 2, corner.y + (size.y - extent.y) / 2),
        ImGui::GetColorU32(ImGuiCol_TextDisabled), text);
}

}  // namespace studio
