// SPDX-License-Identifier: MIT
// `zeroset bench`: run time against error.
#pragma once

#include "cli/bench_options.h"

namespace cli {

int bench_command(const BenchOptions& options);

}  // namespace cli
