// SPDX-License-Identifier: MIT
// `zeroset check`: parses and checks; renders nothing.
#pragma once

#include "cli/input.h"

namespace cli {

struct CheckOptions {
    bool facts = false;  ///< print what is known about the scene
    bool json = false;   ///< the same for machines
};

int check(const InputOptions& input_options, const CheckOptions& options);

}  // namespace cli
