// SPDX-License-Identifier: MIT
// Gives any text to parser and lowering, and stops where what comes back breaks a promise of their
// headers. Built by clang with libFuzzer, see docs/contributing.md.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "formula/limits.h"
#include "formula/lower.h"
#include "formula/parse.h"
#include "formula/print_ast.h"
#include "formula/print_formula.h"

namespace {

void require(bool holds, const char* promise, std::string_view text) {
    if (holds) return;
    std::fprintf(stderr, "broken promise: %s\n%.*s\n", promise, static_cast<int>(text.size()),
                 text.data());
    std::abort();
}

void check_diagnostics(const base::Diagnostics& diagnostics, std::string_view text) {
    require(diagnostics.size() <= formula::max_errors, "at most max_errors are reported", text);
    for (const base::Diagnostic& it : diagnostics) {
        require(it.span.has_value(), "every diagnostic has a place", text);
        require(it.span->begin <= it.span->end && it.span->end <= text.size(),
                "the place is inside the text", text);
        require(!base::format(it, "formula", text).empty(), "a diagnostic can be shown", text);
    }
}

/// Printed and parsed again, the tree is the same. A text that is short enough to be printed within
/// the limits is assumed.
void check_printed(const formula::Program& program, std::string_view text) {
    const std::string printed = formula::print_formula(program);
    const formula::Reading again = formula::read(printed);
    require(again.errors.empty(), "a printed formula has no errors of form", text);
    require(formula::print_ast(*again.program) == formula::print_ast(program),
            "a printed formula has the same tree", text);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const formula::Reading reading = formula::read(text);
    check_diagnostics(reading.errors, text);
    if (reading.program && reading.errors.empty()) check_printed(*reading.program, text);
    const base::Result<formula::Lowered> lowered = formula::understand(text);
    require(!lowered || reading.errors.empty(), "what has errors of form is not lowered", text);
    require(lowered || !lowered.problems().empty(), "what is refused has an error", text);
    check_diagnostics(lowered ? lowered->warnings : lowered.problems(), text);
    return 0;
}
