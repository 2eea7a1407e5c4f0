// SPDX-License-Identifier: MIT
// `zeroset emit`: prints what the compiler made.
#pragma once

#include "cli/input.h"
#include "cli/render_options.h"

namespace cli {

/// What to print.
enum class Emitted { glsl, graph, ast };

int emit(const InputOptions& input, const RenderOptions& options, Emitted what);

}  // namespace cli
