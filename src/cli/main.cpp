// SPDX-License-Identifier: MIT
// The program `zeroset`.
#include "cli/run.h"

int main(int argc, char** argv) { return cli::run(argc, argv); }
