// SPDX-License-Identifier: MIT
// Colours of fields by name.
#include "field/palette.h"
#include "formula/combination_arguments.h"
#include "formula/combination_builders.h"

namespace formula {

Value build_colour(Lowering& lowering, const Call& call) {
    constexpr Slot slots[] = {{"", true}, {"c", true}};
    const auto arguments = CombinationArguments::of(lowering, call, slots);
    if (!arguments) return Nothing{};
    const auto a = arguments->field(0);
    const auto colour = arguments->colour(1);
    if (!a || !colour) return Nothing{};
    return FieldValue{field::coloured(lowering.field, a->field.id, *colour), a->field.objects};
}

}  // namespace formula
