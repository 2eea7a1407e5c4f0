// SPDX-License-Identifier: MIT
// What the dialogs hold while they are open. At most one is open at a time.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "scene/document.h"

namespace studio {

/// What waits for the user's answer about unsaved changes.
struct PendingAction {
    enum class Kind { new_document, open, quit };
    Kind kind = Kind::quit;
    std::filesystem::path file;  ///< to open
};

/// The state of all dialogs. `wanted` is opened in the next frame.
struct Dialogs {
    enum class Kind { none, open, save_as, unsaved, screenshot, recover };
    Kind wanted = Kind::none;
    Kind shown = Kind::none;

    std::string name;        ///< in "Open" and "Save as": what the user types
    std::string problem;     ///< why the last attempt failed
    bool overwrite = false;  ///< "Save as" asks whether to replace the file
    std::optional<PendingAction> pending;

    int still_width = 1920, still_height = 1080;
    std::string still_path;
    bool still_wanted = false;  ///< the picture shall be drawn now

    std::optional<scene::Document> recovered;  ///< what an interrupted run left

    bool open() const { return wanted != Kind::none || shown != Kind::none; }
    void show(Kind kind) {
        wanted = kind;
        problem.clear();
        overwrite = false;
    }
};

}  // namespace studio
