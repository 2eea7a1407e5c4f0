// SPDX-License-Identifier: MIT
#include "cli/emit_command.h"

#include <cstdio>

#include <fmt/format.h>

#include "cli/emit_passes.h"
#include "cli/run.h"
#include "formula/parse.h"
#include "formula/print_ast.h"

namespace cli {

int emit(const InputOptions& input_options, const RenderOptions& options, Emitted what) {
    auto input = read_input(input_options);
    if (!input) return failed;
    if (!apply(options, *input)) return usage;
    switch (what) {
        case Emitted::glsl:
            fmt::print("{}",
                       compile::program_source(input->formula, input->document, shader::Outputs{})
                           .fragment);
            break;
        case Emitted::graph:
            fmt::print("{}", *emit_passes(input->document.formula));
            break;
        case Emitted::ast:
            fmt::print("{}", formula::print_ast(*formula::parse(input->document.formula)));
            break;
    }
    return success;
}

}  // namespace cli
