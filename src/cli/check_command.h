// SPDX-License-Identifier: MIT
// `zeroset check`: parses and checks; renders nothing.
#pragma once

#include "cli/input.h"

namespace cli {

int check(const InputOptions& options);

}  // namespace cli
