// SPDX-License-Identifier: MIT
// Everything that the panels show and change: the open document, where it comes from, what the
// compiler said about it, and messages to the user.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "compile/precision.h"
#include "field/field.h"
#include "scene/document.h"
#include "shader/field_numbers.h"
#include "studio/accuracy.h"
#include "studio/dialog.h"
#include "studio/history.h"
#include "studio/live_picture.h"
#include "studio/preset_list.h"

struct ImFont;

namespace studio {

/// Something that happened. Errors stay until they are dismissed; all stay in the log.
struct Message {
    enum class Kind { note, error };
    Kind kind = Kind::note;
    std::string text;
    double seconds = -1;  ///< when it was first shown; negative: not yet
    bool dismissed = false;
};

/// What the compiler said last.
struct Compilation {
    std::string text;  ///< what the diagnostics speak of
    base::Diagnostics diagnostics;
    base::Diagnostics failures;
    std::vector<field::Parameter> parameters;  ///< of the last formula that was understood
    shader::FieldNumbers field_numbers;
    scene::Bounds bounds;                ///< what the values hold for
    std::string steps;                   ///< how the steps of its rays are found: compile::summary
    compile::PrecisionChoice precision;  ///< of the newest program
    bool drawable = false;               ///< there is a program
    bool busy = false;
};

/// A clock for t that runs without changing the document.
struct Playback {
    bool playing = false;
    double time = 0;
};

/// What the user interface shows, apart from the document.
struct View {
    bool presets = true;
    bool accuracy = false;
    bool help = false;
    bool log = false;
    bool panels = true;
    bool focus_formula = false;   ///< give the formula's editor the keyboard
    bool reload_formula = false;  ///< the text has changed behind the editor's back
    float left_width = 388;
    float right_width = 226;
    float formula_height = 250;
    float accuracy_width = 340;
    float accuracy_height = 580;
    std::string preset_filter;
};

/// The picture's place in the window, in its own pixels.
struct PictureArea {
    int width = 0, height = 0;
    double aspect() const { return height > 0 ? static_cast<double>(width) / height : 1; }
};

struct Workspace {
    explicit Workspace(scene::Document initial);

    scene::Document document;
    scene::Document saved;                      ///< the document as it is in its file
    std::optional<std::filesystem::path> file;  ///< none: never saved
    bool shipped = false;                       ///< the file is one of the shipped presets
    History history;

    Compilation compilation;
    Playback playback;
    Accuracy accuracy;
    View view;
    PictureArea area;
    Dialogs dialogs;
    PresetLists presets;
    std::vector<Message> messages;
    std::optional<PictureReport> report;
    PictureLayers layers;
    std::string renderer;
    bool picture_complete = true;
    bool drawing_still = false;
    bool quit = false;          ///< the studio shall end
    std::uint64_t gesture = 0;  ///< of the picture's wheel and keys in this frame; 0: none
    ImFont* monospaced = nullptr;
    float scale = 1;

    bool unsaved() const { return document != saved; }
    /// The title, else the file's name, else "untitled".
    std::string name() const;
    /// The document as it is drawn: with the running time.
    scene::Document shown() const;
    scene::Camera camera() const { return scene::camera_of(document, area.aspect()); }

    void note(std::string text);
    void error(std::string text);
    void report_problems(const base::Diagnostics& problems);

    void undo();
    void redo();
    /// Puts another document in the place of the open one and begins a new history.
    void replace(scene::Document next, std::optional<std::filesystem::path> from, bool is_shipped);
    /// Starts and stops the running of t; stopping writes it into the document.
    void play(bool on);

private:
    void go_to(const scene::Document& value);
};

/// What is opened when nothing else is.
scene::Document first_document();

}  // namespace studio
