// SPDX-License-Identifier: MIT
// One run of the studio: the loop that joins window, interface, compiler and picture.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/result.h"
#include "studio/accuracy_check.h"
#include "studio/autosave.h"
#include "studio/compiler_thread.h"
#include "studio/gui.h"
#include "studio/input_queue.h"
#include "studio/picture_thread.h"
#include "studio/studio.h"
#include "studio/window.h"
#include "studio/workspace.h"

namespace studio {

/// Nothing is drawn while nothing happens: a step waits for events, for the compiler, or for the
/// time at which something is due.
class EventLoop {
public:
    EventLoop(Window& window, const Options& options);

    /// One round of the loop. False when the user has closed the studio.
    bool step();

private:
    double wait_seconds() const;
    void take_answers();
    void look_at_accuracy();
    void start_trial();
    void ask_compiler();
    void ask_for_picture();
    void look_at_picture();
    void draw_interface();
    void show_picture_and_panels();
    void record();
    Gesture gesture();
    void keep_safe();
    void start_still();
    void say(const base::Diagnostics& problems);

    Window& window_;
    Workspace workspace_;
    Gui gui_;
    InputQueue input_;
    Autosave autosave_;
    PictureThread picture_;
    CompilerThread compiler_;
    AccuracyCheck accuracy_;

    std::optional<scene::Document> asked_;  ///< what the compiler was asked about last
    std::string picture_problem_;           ///< what went wrong with the picture last
    int frames_to_draw_ = 3;
    std::uint64_t presses_ = 0;  ///< of mouse buttons
    bool was_pressed_ = false;
    double last_frame_ = 0;
    double accuracy_shown_ = 0;  ///< when the panel was last drawn because of its own news
};

}  // namespace studio
