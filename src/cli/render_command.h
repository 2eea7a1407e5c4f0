// SPDX-License-Identifier: MIT
// `zeroset render`: draws without a display.
#pragma once

#include <string>

#include "cli/input.h"
#include "cli/render_options.h"

namespace cli {

/// Files to write; empty ones are not written. `stats` may be `-` for standard output.
struct RenderOutputs {
    std::string picture, depth, normal, certificate, stats;
    int repeat = 0;
};

int render_command(const InputOptions& input, const RenderOptions& options,
                   const RenderOutputs& outputs);

}  // namespace cli
