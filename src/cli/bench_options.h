// SPDX-License-Identifier: MIT
// What `zeroset bench` can be told.
#pragma once

#include <string>
#include <vector>

#include "bench/measure.h"

namespace CLI {
class App;
}

namespace cli {

/// Files and folders are empty where nothing is to be written or read.
struct BenchOptions {
    std::vector<std::string> presets;
    bench::Options run;
    std::string backend = "osmesa";
    bool no_reference = false;
    std::string csv, json, html;
    std::string baseline;
    bool fail_on_regression = false;
    std::string docs;
    std::string command;  ///< as it was typed
};

/// Adds all of them to the subcommand.
void add_bench_options(CLI::App& command, BenchOptions& options);

}  // namespace cli
