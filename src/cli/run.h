// SPDX-License-Identifier: MIT
// The command line as a whole.
#pragma once

namespace cli {

/// Exit statuses of the program.
enum Exit : int {
    success = 0,
    failed = 1,  ///< the input is at fault, or the run failed
    usage = 2,   ///< wrong usage
};

/// Runs `zeroset`; results go to standard output, errors to standard error. Returns the exit
/// status.
int run(int argc, char** argv);

}  // namespace cli
