// SPDX-License-Identifier: MIT
// `zeroset oracle`: the reference picture on the CPU.
#pragma once

#include <string>

#include "cli/input.h"
#include "cli/render_options.h"

namespace cli {

/// Files to write; empty ones are not written. `stats` may be `-` for standard output.
struct OracleOptions {
    std::string picture, depth, normal, stats, certificate, reference;
    int threads = 0;
    bool no_cache = false;
};

/// Adds all of them to a subcommand.
void add_oracle_options(CLI::App& command, OracleOptions& options);

int oracle_command(const InputOptions& input, const RenderOptions& render,
                   const OracleOptions& options);

}  // namespace cli
