// SPDX-License-Identifier: MIT
// Set operations by name.
#include <fmt/format.h>

#include "formula/combination_builders.h"
#include "formula/combinations.h"
#include "formula/functions.h"
#include "formula/repeated_field.h"
#include "formula/set_operations.h"

namespace formula {
namespace {

std::optional<std::vector<FieldOperand>> operands(Lowering& lowering, const Call& call) {
    std::vector<FieldOperand> list;
    for (const ExpressionId id : call.arguments) {
        if (const std::optional<FieldValue> field = as_field(lowering, id)) {
            list.push_back({*field, id});
        }
    }
    if (list.size() < call.arguments.size()) return std::nullopt;
    return list;
}

bool has_count(Lowering& lowering, const Call& call, std::size_t least, std::size_t most) {
    const std::size_t count = call.arguments.size();
    if (count >= least && count <= most) return true;
    lowering.error(call.name,
                   fmt::format("'{}' takes {}{} field{}, not {}; write '{}'", call.function, least,
                               most > least ? " or more" : "", least == 1 ? "" : "s", count,
                               find_combination(call.function)->signature));
    return false;
}

}  // namespace

Value build_union(Lowering& lowering, const Call& call) {
    if (has_repeated_field(lowering, call)) {
        if (!has_count(lowering, call, 2, 2)) return Nothing{};
        const auto copies = repeated_field(lowering, call);
        return copies ? Value(unite(lowering, *copies)) : Nothing{};
    }
    const auto fields = operands(lowering, call);
    if (!has_count(lowering, call, 2, any_number) || !fields) return Nothing{};
    return unite(lowering, *fields);
}

Value build_intersection(Lowering& lowering, const Call& call) {
    const auto fields = operands(lowering, call);
    if (!has_count(lowering, call, 2, any_number) || !fields) return Nothing{};
    return intersect(lowering, *fields);
}

Value build_difference(Lowering& lowering, const Call& call) {
    const auto fields = operands(lowering, call);
    if (!has_count(lowering, call, 2, 2) || !fields) return Nothing{};
    const std::optional<FieldValue> outside = complement(lowering, (*fields)[1]);
    if (!outside) return Nothing{};
    return intersect(lowering, {(*fields)[0], {*outside, (*fields)[1].expression}});
}

Value build_complement(Lowering& lowering, const Call& call) {
    const auto fields = operands(lowering, call);
    if (!has_count(lowering, call, 1, 1) || !fields) return Nothing{};
    const std::optional<FieldValue> outside = complement(lowering, (*fields)[0]);
    if (!outside) return Nothing{};
    return *outside;
}

}  // namespace formula
