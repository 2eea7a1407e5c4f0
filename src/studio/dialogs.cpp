// SPDX-License-Identifier: MIT
// The dialogs: names of files, questions about unsaved work, pictures, recovery.
#include <algorithm>
#include <filesystem>
#include <utility>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "render/still.h"
#include "scene/preset.h"
#include "studio/actions.h"
#include "studio/dialog.h"
#include "studio/document_file.h"
#include "studio/panels.h"

namespace studio {
namespace {

const char* title_of(Dialogs::Kind kind) {
    switch (kind) {
        case Dialogs::Kind::none:
            return "";
        case Dialogs::Kind::open:
            return "Open";
        case Dialogs::Kind::save_as:
            return "Save as";
        case Dialogs::Kind::unsaved:
            return "Unsaved changes";
        case Dialogs::Kind::screenshot:
            return "Screenshot";
        case Dialogs::Kind::recover:
            return "Recover unsaved work";
    }
    return "";
}

void close(Dialogs& dialogs) {
    dialogs.shown = Dialogs::Kind::none;
    ImGui::CloseCurrentPopup();
}

void fail(Dialogs& dialogs, const base::Diagnostics& problems) {
    dialogs.problem.clear();
    for (const auto& problem : problems) {
        dialogs.problem += (dialogs.problem.empty() ? "" : "\n") + problem.message;
    }
}

void show_problem(const Dialogs& dialogs) {
    if (dialogs.problem.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0.96f, 0.48f, 0.43f, 1));
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(dialogs.problem.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

bool pressed(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), false); }

/// The two buttons at the bottom. A dialog may also be left with Escape.
enum class Choice { none, yes, cancel };
Choice choose(const char* yes, float scale) {
    ImGui::Spacing();
    const ImVec2 size(110 * scale, 0);
    Choice choice = Choice::none;
    if (ImGui::Button(yes, size)) choice = Choice::yes;
    ImGui::SameLine();
    if (ImGui::Button("Cancel", size) || pressed(ImGuiKey_Escape)) choice = Choice::cancel;
    return choice;
}

/// The name that is typed, with the keyboard on it from the start. True on Enter.
bool ask_name(Dialogs& dialogs, const char* hint) {
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 32);
    const std::string before = dialogs.name;
    const bool enter = ImGui::InputTextWithHint(
        "##name", hint, &dialogs.name,
        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    if (dialogs.name != before) {
        dialogs.overwrite = false;
        dialogs.problem.clear();
    }
    return enter;
}

void show_open(Workspace& workspace) {
    Dialogs& dialogs = workspace.dialogs;
    ImGui::TextUnformatted("Name of a preset, or the path of its file");
    const bool enter = ask_name(dialogs, "surfaces/heart");
    show_problem(dialogs);
    const Choice choice = choose("Open", workspace.scale);
    if (choice == Choice::cancel) return close(dialogs);
    if (!enter && choice != Choice::yes) return;
    auto file = scene::find_preset(dialogs.name);
    if (!file) return fail(dialogs, file.problems());
    close(dialogs);
    start(workspace, {PendingAction::Kind::open, *file});
}

/// Goes on with what the user wanted before the question about unsaved changes.
void resume(Workspace& workspace) {
    if (const auto pending = std::exchange(workspace.dialogs.pending, std::nullopt)) {
        carry_out(workspace, *pending);
    }
}

void show_save_as(Workspace& workspace) {
    Dialogs& dialogs = workspace.dialogs;
    ImGui::TextUnformatted("Name of the preset, with a folder if you like, or a path");
    bool agreed = ask_name(dialogs, "my surfaces/egg");
    const auto path = preset_path(dialogs.name);
    if (path) ImGui::TextDisabled("%s", path->c_str());
    if (dialogs.overwrite) {
        ImGui::TextColored(ImVec4(0.91f, 0.75f, 0.35f, 1),
                           "There is such a file already. Replace it?");
    }
    show_problem(dialogs);
    const Choice choice = choose(dialogs.overwrite ? "Replace" : "Save", workspace.scale);
    if (choice == Choice::cancel) {
        dialogs.pending.reset();
        return close(dialogs);
    }
    agreed = agreed || choice == Choice::yes;
    if (!agreed) return;
    if (!path) return fail(dialogs, path.problems());
    std::error_code none;
    const bool own = workspace.file == *path && !workspace.shipped;
    if (std::filesystem::exists(*path, none) && !own && !dialogs.overwrite) {
        dialogs.overwrite = true;
        return;
    }
    if (auto status = save_file(workspace, *path); !status) return fail(dialogs, status.problems());
    close(dialogs);
    resume(workspace);
}

void show_unsaved(Workspace& workspace) {
    Dialogs& dialogs = workspace.dialogs;
    ImGui::Text("'%s' has changes that are not saved.", workspace.name().c_str());
    ImGui::Spacing();
    const ImVec2 size(110 * workspace.scale, 0);
    if (ImGui::Button("Save", size) || pressed(ImGuiKey_Enter)) {
        close(dialogs);
        save(workspace);
        // Asking for a name comes first; a failure is shown, and nothing is lost.
        if (!workspace.unsaved()) return resume(workspace);
        if (dialogs.wanted == Dialogs::Kind::none) dialogs.pending.reset();
        return;
    }
    ImGui::SameLine();
    if (ImGui::Button("Discard", size)) {
        close(dialogs);
        return resume(workspace);
    }
    ImGui::SameLine();
    if (ImGui::Button("Cancel", size) || pressed(ImGuiKey_Escape)) {
        dialogs.pending.reset();
        close(dialogs);
    }
}

void show_screenshot(Workspace& workspace) {
    Dialogs& dialogs = workspace.dialogs;
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 8);
    ImGui::InputInt("##width", &dialogs.still_width, 0);
    ImGui::SameLine();
    ImGui::TextUnformatted("x");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 8);
    ImGui::InputInt("pixels", &dialogs.still_height, 0);
    dialogs.still_width = std::clamp(dialogs.still_width, 1, render::largest_side);
    dialogs.still_height = std::clamp(dialogs.still_height, 1, render::largest_side);
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 32);
    const bool enter =
        ImGui::InputText("##path", &dialogs.still_path, ImGuiInputTextFlags_EnterReturnsTrue);
    show_problem(dialogs);
    const Choice choice = choose("Draw", workspace.scale);
    if (choice == Choice::cancel) return close(dialogs);
    if (!enter && choice != Choice::yes) return;
    const auto path = picture_path(dialogs.still_path);
    if (!path) return fail(dialogs, path.problems());
    dialogs.still_path = path->string();
    dialogs.still_wanted = true;
    close(dialogs);
}

void show_recover(Workspace& workspace) {
    Dialogs& dialogs = workspace.dialogs;
    ImGui::TextUnformatted("The studio was not closed last time, and there is unsaved work:");
    ImGui::Spacing();
    ImGui::PushFont(workspace.monospaced);
    ImGui::TextUnformatted(dialogs.recovered->formula.substr(0, 400).c_str());
    ImGui::PopFont();
    ImGui::Spacing();
    if (ImGui::Button("Recover", ImVec2(110 * workspace.scale, 0)) || pressed(ImGuiKey_Enter)) {
        workspace.replace(*std::exchange(dialogs.recovered, std::nullopt), std::nullopt, false);
        workspace.saved = first_document();
        return close(dialogs);
    }
    ImGui::SameLine();
    if (ImGui::Button("Discard", ImVec2(110 * workspace.scale, 0))) {
        dialogs.recovered.reset();
        close(dialogs);
    }
}

void show(Workspace& workspace, Dialogs::Kind kind) {
    switch (kind) {
        case Dialogs::Kind::none:
            return;
        case Dialogs::Kind::open:
            return show_open(workspace);
        case Dialogs::Kind::save_as:
            return show_save_as(workspace);
        case Dialogs::Kind::unsaved:
            return show_unsaved(workspace);
        case Dialogs::Kind::screenshot:
            return show_screenshot(workspace);
        case Dialogs::Kind::recover:
            return show_recover(workspace);
    }
}

}  // namespace

void show_dialogs(Workspace& workspace) {
    Dialogs& dialogs = workspace.dialogs;
    if (dialogs.wanted != Dialogs::Kind::none && dialogs.shown == Dialogs::Kind::none) {
        dialogs.shown = std::exchange(dialogs.wanted, Dialogs::Kind::none);
        ImGui::OpenPopup(title_of(dialogs.shown));
    }
    if (dialogs.shown == Dialogs::Kind::none) return;
    const ImVec2 centre = ImGui::GetMainViewport()->GetCenter();
    ImGui::SetNextWindowPos(centre, ImGuiCond_Appearing, ImVec2(0.5f, 0.5f));
    constexpr ImGuiWindowFlags flags =
        ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings;
    if (ImGui::BeginPopupModal(title_of(dialogs.shown), nullptr, flags)) {
        show(workspace, dialogs.shown);
        ImGui::EndPopup();
    } else {
        dialogs.shown = Dialogs::Kind::none;
    }
}

}  // namespace studio
