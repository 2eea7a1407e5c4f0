// SPDX-License-Identifier: MIT
// Lowers `v.x` and `v.xz`.
#include <fmt/format.h>

#include <algorithm>

#include "formula/lowering.h"

namespace formula {
namespace {

constexpr std::string_view letters = "xyzw";

/// True if all components are there once each.
bool is_permutation(const VectorValue& vector, std::string_view of) {
    if (of.size() != vector.components.size()) return false;
    return std::ranges::all_of(of, [&](char it) { return std::ranges::count(of, it) == 1; });
}

}  // namespace

Value lower_component(Lowering& lowering, const Component& component) {
    const Value value = lower_expression(lowering, component.operand);
    if (is_nothing(value) || report_function(lowering, lowering.span(component.operand), value)) {
        return Nothing{};
    }
    const auto* vector = std::get_if<VectorValue>(&value);
    if (!vector) {
        lowering.error(component.name, fmt::format("{} has no components; '.{}' needs a vector",
                                                   describe(value), component.letters));
        return Nothing{};
    }
    VectorValue result;
    for (const char letter : component.letters) {
        const std::size_t place = letters.find(letter);
        if (place >= vector->components.size()) {
            lowering.error(
                component.name,
                fmt::format(
                    "{} has no component '{}'; its components are {}", describe(value), letter,
                    std::string_view("x, y, z, w").substr(0, 3 * vector->components.size() - 2)));
            return Nothing{};
        }
        result.components.push_back(vector->components[place]);
    }
    if (result.components.size() == 1) return result.components[0];
    if (is_permutation(*vector, component.letters)) result.orbit = vector->orbit;
    return result;
}

}  // namespace formula
