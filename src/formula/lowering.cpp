// SPDX-License-Identifier: MIT
#include "formula/lowering.h"

#include <fmt/format.h>

namespace formula {
namespace {

constexpr int most_calls_shown = 4;

/// ` (in the call of 'g' on line 2, in the call of 'f' on line 7)`, the innermost first.
std::string calls(const Frame* frame) {
    std::string text;
    int shown = 0;
    for (; frame; frame = frame->outer) {
        if (frame->caller->library) continue;
        text += text.empty() ? " (" : ", ";
        if (++shown > most_calls_shown) {
            text += "…";
            break;
        }
        const std::size_t line = base::line_column(frame->caller->text, frame->call.begin).line;
        text += fmt::format("in the call of '{}' on line {}", frame->function, line);
    }
    return text.empty() ? text : text + ")";
}

}  // namespace

std::size_t Lowering::line(base::SourceSpan span) const {
    return base::line_column(source->text, span.begin).line;
}

void Lowering::error(base::SourceSpan span, std::string message) {
    const Frame* around = frame;
    const Source* place = source;
    if (place->library) {
        while (around && around->caller->library) around = around->outer;
        if (around) {
            span = around->call;
            message = fmt::format("'{}': {}", around->function, message);
            around = around->outer;
        }
    }
    if (!reported.insert({span.begin, message}).second) return;
    errors.push_back(base::error(span, message + calls(around)));
}

void Lowering::warning(base::SourceSpan span, std::string message) {
    if (source->library || !reported.insert({span.begin, message}).second) return;
    warnings.push_back(base::warning(span, std::move(message)));
}

}  // namespace formula
