// SPDX-License-Identifier: MIT
// Lowers calls: finds out what is called, and with which values.
#include <fmt/format.h>

#include "field/primitives.h"
#include "formula/apply.h"
#include "formula/arguments.h"
#include "formula/arithmetic.h"
#include "formula/built_in.h"
#include "formula/combinations.h"
#include "formula/prelude.h"
#include "formula/user_function.h"

namespace formula {
namespace {

using graph::NodeId;

Value operand(Lowering& lowering, const Call& call, ExpressionId id) {
    auto value = as_operand(lowering, id, fmt::format("as an argument of '{}'", call.function));
    return value ? *std::move(value) : Value(Nothing{});
}

Value call_function(Lowering& lowering, const Call& call, const Function& function) {
    std::vector<Value> arguments;
    for (const ExpressionId id : call.arguments) arguments.push_back(operand(lowering, call, id));
    return apply(lowering, function, call.name, arguments);
}

Value call_vector_function(Lowering& lowering, const Call& call, const VectorFunction& function) {
    const std::optional<Bound> bound = bind(lowering, call, function.slots, false);
    if (!bound) return Nothing{};
    std::vector<Value> arguments(function.slots.size());
    bool broken = false;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (!(*bound)[i]) continue;
        arguments[i] = operand(lowering, call, *(*bound)[i]);
        broken = broken || is_nothing(arguments[i]);
    }
    if (broken) return Nothing{};
    return apply(lowering, function, call.name, arguments);
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

Value call_built_in(Lowering& lowering, const Call& call) {
    if (call.function == "if") return lower_if(lowering, call);
    if (const Function* function = find_function(call.function)) {
        return call_function(lowering, call, *function);
    }
    if (const VectorFunction* function = find_vector_function(call.function)) {
        return call_vector_function(lowering, call, *function);
    }
    if (const Combination* combination = find_combination(call.function)) {
        return combination->build(lowering, call);
    }
    if (is_in_prelude(call.function)) {
        return call_library_function(lowering, prelude_function(call.function), call);
    }
    return call_primitive(lowering, call, *field::find_primitive(call.function));
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
    const bool known = find_binding(lowering.scope, call.function) ||
                       built_in_number(lowering, call.function) || is_callable(call.function);
    if (!known) {
        report_unknown_name(lowering, call.function, call.name);
        lower_arguments(lowering, call);
        return Nothing{};
    }
    const Value value = lower_name(lowering, call.function, call.name);
    if (const auto* function = std::get_if<FunctionValue>(&value)) {
        if (function->definition) return call_user_function(lowering, *function, call);
        if (function->name == call.function) return call_built_in(lowering, call);
        Call renamed = call;
        renamed.function = function->name;
        return call_built_in(lowering, renamed);
    }
    // What was never given a value has been reported where that failed.
    if (!is_nothing(value)) report_no_function(lowering, call, value);
    lower_arguments(lowering, call);
    return Nothing{};
}

}  // namespace formula
