// SPDX-License-Identifier: MIT
// What a command works on: a preset, or a formula given as text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "compile/compile.h"
#include "scene/document.h"
#include "scene/parameter_value.h"

namespace CLI {
class App;
}

namespace cli {

/// The two ways to name an input; exactly one is set after parsing.
struct InputOptions {
    std::string preset;
    std::optional<std::string> formula;
};

/// Adds PRESET and --formula to a subcommand.
void add_input_options(CLI::App& command, InputOptions& options);

/// Where a formula is from, to report places in it.
struct Source {
    std::string name;  ///< of the file, or `formula`
    std::string text;  ///< all of the file, or the formula
    /// Of each byte of the formula in the text; empty: the same.
    std::vector<std::uint32_t> places;
    scene::ParameterPlaces parameters;  ///< in the text
};

/// An input that was understood.
struct Input {
    Source source;
    scene::Document document;
    compile::Formula formula;
    double parse_seconds = 0;
};

/// Reads and compiles. Errors and warnings go to standard error in the contract's form, with places
/// in the preset's file or in `formula`; none is returned if there were errors.
std::optional<Input> read_input(const InputOptions& options);

/// Writes diagnostics of the formula to standard error, with places in its source.
void report(const Source& source, const base::Diagnostics& problems);

/// Writes diagnostics without a place to standard error, each under the program's name.
void report(const base::Diagnostics& problems);

}  // namespace cli
