// SPDX-License-Identifier: MIT
#include "formula/user_function.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "formula/arguments.h"
#include "formula/mentions.h"

namespace formula {
namespace {

/// Puts the lowering into another text and scope, for as long as it lives.
class Elsewhere {
public:
    Elsewhere(Lowering& lowering, const Source* source, Scope* scope, const Frame* frame)
        : lowering_(lowering),
          source_(lowering.source),
          scope_(lowering.scope),
          frame_(lowering.frame) {
        lowering.source = source;
        lowering.scope = scope;
        lowering.frame = frame;
    }
    ~Elsewhere() {
        lowering_.source = source_;
        lowering_.scope = scope_;
        lowering_.frame = frame_;
    }
    Elsewhere(const Elsewhere&) = delete;
    Elsewhere& operator=(const Elsewhere&) = delete;

private:
    Lowering& lowering_;
    const Source* source_;
    Scope* scope_;
    const Frame* frame_;
};

Scope scope_of(const FunctionValue& function) { return {function.scope, function.visible}; }

void warn_of_unused_parameters(Lowering& lowering, const Definition& definition) {
    const Mentions names = mentions(lowering.source->program, definition.value);
    for (const FunctionParameter& it : *definition.parameters) {
        if (names.contains(it.name)) continue;
        lowering.warning(it.span, fmt::format("the parameter '{}' of '{}' is never used", it.name,
                                              definition.name));
    }
}

std::vector<Slot> slots_of(const Definition& definition) {
    std::vector<Slot> slots;
    for (const FunctionParameter& it : *definition.parameters) {
        slots.push_back({it.name, !it.initial});
    }
    return slots;
}

/// A call whose arguments are found, each of which `lower_argument` makes a value.
template <class LowerArgument>
Value call_bound(Lowering& lowering, const FunctionValue& function, const Call& call,
                 const std::optional<Bound>& bound, LowerArgument lower_argument) {
    if (!bound) return Nothing{};
    std::vector<Value> arguments(bound->size());
    bool broken = false;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (!(*bound)[i]) continue;
        arguments[i] = lower_argument(i, *(*bound)[i]);
        broken = broken || is_nothing(arguments[i]);
    }
    if (broken) return Nothing{};
    return call_user_function(lowering, function, call.name, arguments);
}

}  // namespace

Value define_function(Lowering& lowering, const Definition& definition) {
    const std::size_t errors = lowering.errors.size();
    const FunctionValue function{definition.name, &definition, lowering.source, lowering.scope,
                                 lowering.scope->names.size()};
    InnerScope body(lowering);
    for (const FunctionParameter& it : *definition.parameters) {
        if (it.initial) lower_expression(lowering, *it.initial);
    }
    for (const FunctionParameter& it : *definition.parameters) {
        body.names.set(it.name, Nothing{}, it.span, Role::argument);
    }
    lower_expression(lowering, definition.value);
    warn_of_unused_parameters(lowering, definition);
    if (lowering.errors.size() > errors) return Nothing{};
    return function;
}

Value call_user_function(Lowering& lowering, const FunctionValue& function, const Call& call) {
    const std::vector<Slot> slots = slots_of(*function.definition);
    return call_bound(lowering, function, call, bind_to_user_function(lowering, call, slots),
                      [&](std::size_t, ExpressionId id) { return lower_expression(lowering, id); });
}

Value call_library_function(Lowering& lowering, const FunctionValue& function, const Call& call) {
    const std::vector<FunctionParameter>& parameters = *function.definition->parameters;
    const std::vector<Slot> slots = slots_of(*function.definition);
    const auto lower_argument = [&](std::size_t i, ExpressionId id) -> Value {
        if (!parameters[i].initial) return lower_expression(lowering, id);
        const ExpressionNode& initial = function.source->program[*parameters[i].initial].node;
        const auto* tuple = std::get_if<Tuple>(&initial);
        const auto given = uniform_components(lowering, call, parameters[i].name, id,
                                              tuple ? tuple->parts.size() : 1);
        if (!given) return Nothing{};
        if (!tuple) return (*given)[0];
        return VectorValue{Algebra::vector, *given};
    };
    const bool of_fields = std::ranges::any_of(slots, &Slot::required);
    return call_bound(lowering, function, call, bind(lowering, call, slots, of_fields),
                      lower_argument);
}

Value call_user_function(Lowering& lowering, const FunctionValue& function, base::SourceSpan span,
                         std::span<const Value> arguments) {
    const std::vector<FunctionParameter>& parameters = *function.definition->parameters;
    if (arguments.size() > parameters.size()) {
        lowering.error(
            span, fmt::format("'{}' takes {} argument{}, not {}; it is called '{}'", function.name,
                              parameters.size(), parameters.size() == 1 ? "" : "s",
                              arguments.size(), signature(function)));
        return Nothing{};
    }
    Scope outside = scope_of(function), body = scope_of(function);
    const std::size_t level = lowering.frame ? lowering.frame->level + 1 : 1;
    const Frame frame{lowering.frame, function.name, lowering.source, span, level};
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        Value value = i < arguments.size() ? arguments[i] : Value(Nothing{});
        if (is_nothing(value) && !parameters[i].initial) {
            lowering.error(span, fmt::format("an argument of '{}' is missing; it is called '{}'",
                                             function.name, signature(function)));
            return Nothing{};
        }
        if (is_nothing(value)) {
            const Elsewhere there(lowering, function.source, &outside, &frame);
            value = lower_expression(lowering, *parameters[i].initial);
        }
        body.set(parameters[i].name, std::move(value), parameters[i].span, Role::argument);
    }
    const Elsewhere there(lowering, function.source, &body, &frame);
    return lower_expression(lowering, function.definition->value);
}

std::string signature(const FunctionValue& function) {
    std::string text = function.name + '(';
    const Source& source = *function.source;
    for (const FunctionParameter& it : *function.definition->parameters) {
        if (&it != &function.definition->parameters->front()) text += ", ";
        text += it.name;
        if (!it.initial) continue;
        const base::SourceSpan span = source.program[*it.initial].span;
        text += " = ";
        text += source.text.substr(span.begin, span.end - span.begin);
    }
    return text + ')';
}

}  // namespace formula
