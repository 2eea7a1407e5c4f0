// SPDX-License-Identifier: MIT
#include "cli/check_command.h"

#include "cli/run.h"

namespace cli {

int check(const InputOptions& options) { return read_input(options) ? success : failed; }

}  // namespace cli
