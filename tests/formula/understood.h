// SPDX-License-Identifier: MIT
// What the tests of the language ask about a formula, as strings and numbers.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "eval/field_value.h"
#include "formula/lower.h"
#include "formula/parse.h"
#include "formula/print_ast.h"

namespace formula {

/// `LINE:COLUMN: MESSAGE` of each of them, a line each.
inline std::string list_of(std::string_view text, const base::Diagnostics& diagnostics) {
    std::string list;
    for (const base::Diagnostic& it : diagnostics) {
        const base::LineColumn place = base::line_column(text, it.span->begin);
        if (!list.empty()) list += '\n';
        list += std::to_string(place.line) + ':' + std::to_string(place.column) + ": " + it.message;
    }
    return list;
}

/// All errors of a formula; empty if it is good.
inline std::string errors_of(std::string_view text) {
    return list_of(text, understand(text).problems());
}

/// The errors of form alone.
inline std::string syntax_errors_of(std::string_view text) {
    return list_of(text, read(text).errors);
}

/// Everything as the command line shows it, warnings too.
inline std::string report_of(std::string_view text) {
    const base::Result<Lowered> result = understand(text);
    std::string report;
    for (const base::Diagnostic& it : result ? result->warnings : result.problems()) {
        report += base::format(it, "formula", text);
    }
    return report;
}

/// The tree that print_ast indents, on one line with brackets: `sum(+ x, - power(y, 2))`.
inline std::string on_one_line(std::string_view printed) {
    std::string line;
    std::size_t depth = 0;
    bool first = true;
    while (!printed.empty()) {
        const std::size_t end = printed.find('\n');
        const std::size_t indent = printed.find_first_not_of(' ') / 2;
        for (; depth < indent; ++depth) line += '(', first = true;
        for (; depth > indent; --depth) line += ')';
        if (!first) line += ", ";
        first = false;
        line += printed.substr(2 * indent, end - 2 * indent);
        printed.remove_prefix(end + 1);
    }
    return line.append(depth, ')');
}

/// The tree of the last expression, or the errors.
inline std::string tree_of(std::string_view text) {
    const base::Result<Program> program = parse(text);
    return program ? on_one_line(print_ast(*program, program->result)) : errors_of(text);
}

/// The tree of the whole program, or the errors of form.
inline std::string program_of(std::string_view text) {
    const base::Result<Program> program = parse(text);
    return program ? on_one_line(print_ast(*program)) : syntax_errors_of(text);
}

/// The value of the whole field at a point, with all parameters at their initial values.
inline double value_at(std::string_view text, glm::dvec3 point) {
    const base::Result<Lowered> result = understand(text);
    if (!result) {
        ADD_FAILURE() << report_of(text);
        return std::numeric_limits<double>::quiet_NaN();
    }
    std::vector<double> parameters(result->field.graph.parameter_count(), 0.0);
    for (const field::Parameter& it : result->field.parameters) {
        for (std::size_t i = 0; i < it.size(); ++i) {
            parameters[graph::index(it.ids[i])] = it.initial[i];
        }
    }
    return eval::value(result->field, result->field.root, point, parameters);
}

/// The value of an expression of constants.
inline double value_of(std::string_view text) { return value_at(text, {0, 0, 0}); }

}  // namespace formula
