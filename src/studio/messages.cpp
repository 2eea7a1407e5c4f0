// SPDX-License-Identifier: MIT
// Messages over the picture, and the log of all of them.
#include <algorithm>

#include <imgui.h>

#include "studio/panels.h"

namespace studio {
namespace {

constexpr double note_seconds = 8;
constexpr int most_shown = 5;

ImVec4 colour_of(const Message& message) {
    return message.kind == Message::Kind::error ? ImVec4(0.96f, 0.48f, 0.43f, 1)
                                                : ImVec4(0.80f, 0.84f, 0.88f, 1);
}

bool is_due(const Message& message) {
    if (message.dismissed) return false;
    return message.kind == Message::Kind::error || message.seconds < 0 ||
           ImGui::GetTime() - message.seconds < note_seconds;
}

void show_message(Message& message) {
    ImGui::PushID(&message);
    if (ImGui::SmallButton("x")) message.dismissed = true;
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Text, colour_of(message));
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(message.text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::PopID();
}

}  // namespace

bool has_messages_to_show(const Workspace& workspace) {
    return std::any_of(workspace.messages.begin(), workspace.messages.end(), is_due);
}

void show_messages(Workspace& workspace) {
    for (Message& message : workspace.messages) {
        if (message.seconds < 0) message.seconds = ImGui::GetTime();
    }
    int shown = 0;
    for (auto message = workspace.messages.rbegin();
         message != workspace.messages.rend() && shown < most_shown; ++message) {
        if (!is_due(*message)) continue;
        show_message(*message);
        ++shown;
    }
}

void show_log(Workspace& workspace) {
    if (!workspace.view.log) return;
    ImGui::SetNextWindowSize(ImVec2(520 * workspace.scale, 260 * workspace.scale),
                             ImGuiCond_FirstUseEver);
    if (ImGui::Begin("Messages", &workspace.view.log)) {
        if (workspace.messages.empty()) ImGui::TextDisabled("nothing has happened yet");
        for (const Message& message : workspace.messages) {
            ImGui::PushStyleColor(ImGuiCol_Text, colour_of(message));
            ImGui::TextWrapped("%s", message.text.c_str());
            ImGui::PopStyleColor();
        }
    }
    ImGui::End();
}

}  // namespace studio
