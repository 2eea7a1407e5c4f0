// SPDX-License-Identifier: MIT
#include "formula/building.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "formula/limits.h"
#include "formula/number.h"
#include "formula/tokens.h"
#include "formula/words.h"

namespace formula {
namespace {

Place skip_blanks(Place first, Place last) {
    return std::find_if(first, last, [](char c) { return c != ' ' && c != '\t' && c != '\r'; });
}

}  // namespace

ExpressionId Building::add(ExpressionNode node, base::SourceSpan span) {
    const ExpressionId id = program.add(std::move(node), span);
    if (program[id].height > max_height && !too_high) {
        too_high = true;
        errors.push_back(base::error(
            span, fmt::format("the expression nests more than {} levels deep; give parts of it "
                              "names in definitions",
                              max_height)));
    }
    return id;
}

std::string_view between(Place first, Place last) {
    return {first, static_cast<std::size_t>(last - first)};
}

Place number_end(Place first, Place last) { return first + number_length(between(first, last)); }

Place word_end(Place first, Place last) { return first + name_length(between(first, last)); }

Place name_end(const Building& building, Place first, Place last) {
    const Place end = word_end(first, last);
    const bool called = opens_bracket(end, last);
    return is_name(building.within, between(first, end), called) ? end : first;
}

void check_components(std::string_view letters, base::SourceSpan span, base::Diagnostics& errors) {
    const std::size_t wrong = letters.find_first_not_of("xyzw");
    if (wrong != std::string_view::npos) {
        errors.push_back(base::error(
            span, fmt::format("'{}' is no component; the components are x, y, z and w", letters)));
    } else if (letters.size() > 4) {
        errors.push_back(
            base::error(span, "a vector has at most 4 components; write at most 4 letters"));
    }
}

bool opens_bracket(Place first, Place last) {
    first = skip_blanks(first, last);
    return first != last && *first == '(';
}

bool selects_components(const Building&, Place first, Place last) {
    return first != last && *first == '.' && number_end(first, last) == first;
}

bool implies_product(const Building& building, Place first, Place last) {
    const bool after_bracket = first != building.text && first[-1] == ')';
    if (!after_bracket && first != building.number_end) return false;
    const Place next = skip_blanks(first, last);
    if (opens_bracket(next, last)) return true;
    const Place end = name_end(building, next, last);
    if (end != next) {
        const bool apart = next != first && !opens_bracket(end, last);
        return !apart || !resembles_modifier(building.within, between(next, end));
    }
    return after_bracket && number_end(next, last) != next;
}

}  // namespace formula
