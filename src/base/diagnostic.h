// SPDX-License-Identifier: MIT
// What is wrong with an input or a run, and how it is written for people and editors.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/source_span.h"

namespace base {

enum class Severity { error, warning };

/// One thing to tell the user. The message is a full clause without a final stop; a hint follows
/// after a semicolon ("unknown name 'sine'; did you mean 'sin'?").
struct Diagnostic {
    Severity severity = Severity::error;
    std::string message;
    std::optional<SourceSpan> span;  ///< where, if it is about a place in a text

    friend bool operator==(const Diagnostic&, const Diagnostic&) = default;
};

using Diagnostics = std::vector<Diagnostic>;

/// An error without a place (a file, the driver).
Diagnostic error(std::string message);
/// An error at a place of the text that is being read.
Diagnostic error(SourceSpan span, std::string message);
/// A warning at a place of the text that is being read.
Diagnostic warning(SourceSpan span, std::string message);

/// True if one of them is an error.
bool has_errors(const Diagnostics& diagnostics);

/// A place in a text as people count: both from 1, the column in characters (UTF-8).
struct LineColumn {
    std::size_t line = 1;
    std::size_t column = 1;
};
LineColumn line_column(std::string_view text, std::size_t offset);

/// `NAME:LINE:COLUMN: error: MESSAGE`, the source line, and a caret with tildes under the span
/// (cut off at the end of the line). Without a span: `NAME: error: MESSAGE`. Every line ends in a
/// newline. Long lines are cut to a window around the place.
std::string format(const Diagnostic& diagnostic, std::string_view name, std::string_view text);

}  // namespace base
