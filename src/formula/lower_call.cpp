// SPDX-License-Identifier: MIT
// Lowers calls: functions of numbers, combinations of fields, primitives.
#include <fmt/format.h>

#include "field/primitives.h"
#include "formula/arguments.h"
#include "formula/built_in.h"
#include "formula/combinations.h"
#include "formula/functions.h"

namespace formula {
namespace {

using graph::NodeId;

void lower_all(Lowering& lowering, const Call& call) {
    for (const ExpressionId id : call.arguments) lower_expression(lowering, id);
}

std::string expected_count(const Function& function) {
    const std::string_view plural = function.most == 1 ? "argument" : "arguments";
    if (function.most == any_number) return fmt::format("{} or more {}", function.least, plural);
    if (function.most == function.least) return fmt::format("{} {}", function.least, plural);
    return fmt::format("{} or {} {}", function.least, function.most, plural);
}

Value call_function(Lowering& lowering, const Call& call, const Function& function) {
    std::vector<NodeId> arguments;
    const std::string where = fmt::format("as an argument of '{}'", function.name);
    for (const ExpressionId id : call.arguments) {
        const auto number = as_number(lowering, id, where);
        if (number) arguments.push_back(*number);
    }
    const std::size_t count = call.arguments.size();
    if (count < function.least || count > function.most) {
        lowering.error(call.name, fmt::format("'{}' takes {}, not {}; write '{}'", function.name,
                                              expected_count(function), count, function.signature));
        return Nothing{};
    }
    if (arguments.size() < count) return Nothing{};
    return function.build(lowering.field.graph, arguments);
}

Value call_primitive(Lowering& lowering, const Call& call, const field::Primitive& primitive) {
    std::vector<Slot> slots;
    for (const field::Argument& it : primitive.arguments) slots.push_back({it.name, it.required});
    const std::optional<Bound> bound = bind(lowering, call, slots, false);
    if (!bound) return Nothing{};
    std::vector<NodeId> components;
    bool good = true;
    for (std::size_t i = 0; i < slots.size(); ++i) {
        const field::Argument& argument = primitive.arguments[i];
        if (!(*bound)[i]) {
            for (const double it : argument.initial) {
                components.push_back(lowering.field.graph.constant(it));
            }
            continue;
        }
        const auto given = uniform_components(lowering, call, argument.name, *(*bound)[i],
                                              argument.initial.size());
        good = good && given;
        if (given) components.insert(components.end(), given->begin(), given->end());
    }
    if (!good) return Nothing{};
    const field::FieldId id = primitive.build(lowering.field, components);
    return FieldValue{id, field::leaves(lowering.field, id).size()};
}

/// A name in front of a bracket that cannot be called.
void report_no_function(Lowering& lowering, const Call& call, const Value& value) {
    const Binding* binding = find_binding(lowering.scope, call.function);
    if (binding && is_callable(call.function)) {
        lowering.error(call.name,
                       fmt::format("'{}' is not a function here; line {} gives the name another "
                                   "meaning, choose another one there",
                                   call.function, lowering.line(binding->span)));
        return;
    }
    const bool number = std::holds_alternative<NodeId>(value);
    lowering.error(call.name, fmt::format("'{0}' is not a function{1}", call.function,
                                          number ? fmt::format("; write '{}*(…)'", call.function)
                                                 : std::string()));
}

}  // namespace

Value lower_call(Lowering& lowering, const Call& call) {
    const bool defined = find_binding(lowering.scope, call.function);
    if (!defined && is_callable(call.function)) {
        if (const Function* function = find_function(call.function)) {
            return call_function(lowering, call, *function);
        }
        if (const Combination* combination = find_combination(call.function)) {
            return combination->build(lowering, call);
        }
        return call_primitive(lowering, call, *field::find_primitive(call.function));
    }
    const bool known = defined || built_in_number(lowering, call.function);
    if (known) {
        const Value value = lower_name(lowering, call.function, call.name);
        // What was never given a value has been reported where that failed.
        if (!std::holds_alternative<Nothing>(value)) report_no_function(lowering, call, value);
    } else {
        report_unknown_name(lowering, call.function, call.name);
    }
    lower_all(lowering, call);
    return Nothing{};
}

}  // namespace formula
