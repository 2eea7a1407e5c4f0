// SPDX-License-Identifier: MIT
// What the program of the picture in the window writes.
#pragma once

#include "shader/program_source.h"

namespace studio {

/// Every pass keeps what it finds, for the pictures in which nothing that it reads has changed.
inline constexpr shader::Outputs live_outputs{
    .picture = true, .geometry = true, .normal = true, .light = true};

}  // namespace studio
