// SPDX-License-Identifier: MIT
// The studio: a window in which formulas are typed, seen, and turned.
#pragma once

#include <filesystem>
#include <optional>

#include "base/result.h"

namespace studio {

struct Options {
    std::optional<std::filesystem::path> preset;  ///< opened at the start
    int width = 1280, height = 800;               ///< of the window, in the desktop's units
};

/// Opens the window and runs until the user closes it. It is an error if no window can be opened
/// (no display, no OpenGL 4.5): its text points to `zeroset render`. A preset that cannot be opened
/// is reported in the window.
base::Status run(const Options& options);

}  // namespace studio
