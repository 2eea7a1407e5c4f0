// SPDX-License-Identifier: MIT
// The formula's editor with line numbers and marked lines, and the compiler's words below it.
#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include "studio/panels.h"

namespace studio {
namespace {

constexpr ImU32 error_colour = IM_COL32(240, 110, 100, 255);
constexpr ImU32 warning_colour = IM_COL32(232, 190, 90, 255);
constexpr const char* editor_id = "##formula";

struct MarkedLine {
    std::size_t line;
    base::Severity severity;
};

/// The lines that diagnostics speak of, as long as they speak of this text.
std::vector<MarkedLine> marked_lines(const Workspace& workspace) {
    std::vector<MarkedLine> lines;
    const Compilation& compilation = workspace.compilation;
    if (compilation.text != workspace.document.formula) return lines;
    for (const base::Diagnostic& diagnostic : compilation.diagnostics) {
        if (!diagnostic.span) continue;
        const auto place = base::line_column(compilation.text, diagnostic.span->begin);
        lines.push_back({place.line, diagnostic.severity});
    }
    return lines;
}

/// Undo and opening change the text while the editor has a copy of its own.
int replace_text(ImGuiInputTextCallbackData* data) {
    auto& workspace = *static_cast<Workspace*>(data->UserData);
    if (!workspace.view.reload_formula) return 0;
    workspace.view.reload_formula = false;
    const std::string& text = workspace.document.formula;
    const int cursor = std::min(data->CursorPos, static_cast<int>(text.size()));
    data->DeleteChars(0, data->BufTextLen);
    data->InsertChars(0, text.c_str(), text.c_str() + text.size());
    data->CursorPos = cursor;
    data->SelectionStart = data->SelectionEnd = cursor;
    return 0;
}

/// The numbers beside the editor, scrolled with it; marked lines in the colour of their mark.
void draw_line_numbers(const Workspace& workspace, ImVec2 corner, ImVec2 size, float scroll) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float line_height = ImGui::GetTextLineHeight();
    const auto lines =
        1 + std::count(workspace.document.formula.begin(), workspace.document.formula.end(), '\n');
    const auto marks = marked_lines(workspace);
    const float top = corner.y + ImGui::GetStyle().FramePadding.y - scroll;
    list.PushClipRect(corner, ImVec2(corner.x + size.x, corner.y + size.y), true);
    for (long line = 1; line <= lines; ++line) {
        ImU32 colour = ImGui::GetColorU32(ImGuiCol_TextDisabled);
        for (const MarkedLine& mark : marks) {
            if (static_cast<long>(mark.line) != line) continue;
            colour = mark.severity == base::Severity::error ? error_colour : warning_colour;
        }
        const std::string number = std::to_string(line);
        const float width = ImGui::CalcTextSize(number.c_str()).x;
        const float y = top + static_cast<float>(line - 1) * line_height;
        list.AddText(ImVec2(corner.x + size.x - width - 6, y), colour, number.c_str());
    }
    list.PopClipRect();
}

/// A tint over the marked lines, inside the editor's own window.
void draw_marks(const Workspace& workspace, const ImGuiWindow& editor) {
    const float line_height = ImGui::GetTextLineHeight();
    const ImRect inner = editor.InnerRect;
    editor.DrawList->PushClipRect(inner.Min, inner.Max, false);
    for (const MarkedLine& mark : marked_lines(workspace)) {
        const float y = inner.Min.y + ImGui::GetStyle().FramePadding.y - editor.Scroll.y +
                        static_cast<float>(mark.line - 1) * line_height;
        const bool is_error = mark.severity == base::Severity::error;
        const ImU32 tint = is_error ? IM_COL32(240, 80, 70, 46) : IM_COL32(232, 190, 90, 36);
        const ImU32 bar = is_error ? error_colour : warning_colour;
        editor.DrawList->AddRectFilled(ImVec2(inner.Min.x, y), ImVec2(inner.Max.x, y + line_height),
                                       tint);
        editor.DrawList->AddRectFilled(ImVec2(inner.Min.x, y),
                                       ImVec2(inner.Min.x + 2, y + line_height), bar);
    }
    editor.DrawList->PopClipRect();
}

void show_editor(Workspace& workspace, float height) {
    const ImGuiID id = ImGui::GetID(editor_id);
    const float gutter = 30 * workspace.scale;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + gutter);
    if (workspace.view.focus_formula) ImGui::SetKeyboardFocusHere();
    workspace.view.focus_formula = false;
    const std::string name =
        fmt::format("{}/{}_{:08X}", ImGui::GetCurrentWindow()->Name, editor_id, id);
    constexpr ImGuiInputTextFlags flags = ImGuiInputTextFlags_AllowTabInput |
                                          ImGuiInputTextFlags_NoUndoRedo |
                                          ImGuiInputTextFlags_CallbackAlways;
    ImGui::InputTextMultiline(editor_id, &workspace.document.formula, ImVec2(-1, height), flags,
                              replace_text, &workspace);
    // An editor without the keyboard reads the text anew in each frame.
    if (!ImGui::IsItemActive()) workspace.view.reload_formula = false;
    const ImGuiWindow* editor = ImGui::FindWindowByName(name.c_str());
    if (editor) draw_marks(workspace, *editor);
    draw_line_numbers(workspace, corner, ImVec2(gutter, height), editor ? editor->Scroll.y : 0);
}

/// The message with its line, wrapped to the panel; below it the source line and the caret.
void show_diagnostic(const base::Diagnostic& diagnostic, const Workspace& workspace) {
    const std::string& text = workspace.compilation.text;
    const bool is_error = diagnostic.severity == base::Severity::error;
    std::string message = diagnostic.message;
    if (diagnostic.span) {
        const auto place = base::line_column(text, diagnostic.span->begin);
        message = fmt::format("Line {}, column {}: {}", place.line, place.column, message);
    }
    ImGui::PushStyleColor(ImGuiCol_Text, is_error ? error_colour : warning_colour);
    ImGui::PushTextWrapPos(ImGui::GetScrollX() + ImGui::GetWindowWidth() -
                           ImGui::GetStyle().ScrollbarSize);
    ImGui::TextUnformatted(message.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    const std::string whole = base::format(diagnostic, "formula", text);
    const std::size_t excerpt = std::min(whole.find('\n'), whole.size() - 1) + 1;
    if (excerpt < whole.size()) {
        ImGui::PushFont(workspace.monospaced);
        ImGui::TextUnformatted(whole.c_str() + excerpt, whole.c_str() + whole.size() - 1);
        ImGui::PopFont();
    }
    ImGui::Spacing();
}

void show_verdict(const Workspace& workspace) {
    const Compilation& compilation = workspace.compilation;
    if (compilation.busy) {
        ImGui::TextDisabled("compiling...");
    } else if (compilation.diagnostics.empty() && compilation.failures.empty()) {
        ImGui::TextDisabled(compilation.drawable ? "the formula is understood" : " ");
    }
    for (const auto& diagnostic : compilation.failures) show_diagnostic(diagnostic, workspace);
    for (const auto& diagnostic : compilation.diagnostics) show_diagnostic(diagnostic, workspace);
}

}  // namespace

void show_formula_panel(Workspace& workspace) {
    const Compilation& compilation = workspace.compilation;
    const bool quiet = compilation.diagnostics.empty() && compilation.failures.empty();
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float room = ImGui::GetContentRegionAvail().y;
    const float verdict = quiet ? line : std::min(room * 0.45f, 5.5f * line);
    ImGui::PushFont(workspace.monospaced);
    show_editor(workspace, room - verdict - ImGui::GetStyle().ItemSpacing.y);
    ImGui::PopFont();
    ImGui::BeginChild("verdict", ImVec2(0, 0), false, ImGuiWindowFlags_HorizontalScrollbar);
    show_verdict(workspace);
    ImGui::EndChild();
}

}  // namespace studio
