// SPDX-License-Identifier: MIT
#include "studio/workspace.h"

#include <utility>

namespace studio {

Workspace::Workspace(scene::Document initial)
    : document(initial), saved(initial), history(std::move(initial)) {}

std::string Workspace::name() const {
    if (!document.title.empty()) return document.title;
    return file ? file->stem().string() : "untitled";
}

scene::Document Workspace::shown() const {
    scene::Document result = document;
    if (playback.playing) result.time = playback.time;
    return result;
}

void Workspace::note(std::string text) {
    messages.push_back({.kind = Message::Kind::note, .text = std::move(text)});
}

void Workspace::error(std::string text) {
    messages.push_back({.kind = Message::Kind::error, .text = std::move(text)});
}

void Workspace::report_problems(const base::Diagnostics& problems) {
    for (const base::Diagnostic& problem : problems) error(problem.message);
}

void Workspace::undo() {
    if (history.can_undo()) go_to(history.undo());
}

void Workspace::redo() {
    if (history.can_redo()) go_to(history.redo());
}

void Workspace::replace(scene::Document next, std::optional<std::filesystem::path> from,
                        bool is_shipped) {
    document = next;
    saved = next;
    history = History(std::move(next));
    file = std::move(from);
    shipped = is_shipped;
    playback = {};
    view.reload_formula = true;
}

void Workspace::play(bool on) {
    if (on == playback.playing) return;
    if (on) {
        playback.time = document.time;
    } else {
        document.time = playback.time;
    }
    playback.playing = on;
}

void Workspace::go_to(const scene::Document& value) {
    playback.playing = false;
    view.reload_formula = view.reload_formula || value.formula != document.formula;
    document = value;
}

scene::Document first_document() {
    scene::Document document;
    document.formula =
        "# An equation in x, y, z. A line with param makes a slider.\n"
        "param a = 1.3 in [0.5, 2] \"width\"\n"
        "(x/a)^2 + y^2 + z^2 = 1";
    return document;
}

}  // namespace studio
