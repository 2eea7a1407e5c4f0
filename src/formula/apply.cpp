// SPDX-License-Identifier: MIT
#include "formula/apply.h"

#include <fmt/format.h>

#include <algorithm>

#include "field/primitives.h"
#include "formula/arithmetic.h"
#include "formula/prelude.h"
#include "formula/user_function.h"

namespace formula {
namespace {

using graph::NodeId;

std::string expected_count(const Function& function) {
    const std::string_view plural = function.most == 1 ? "argument" : "arguments";
    if (function.most == any_number) return fmt::format("{} or more {}", function.least, plural);
    if (function.most == function.least) return fmt::format("{} {}", function.least, plural);
    return fmt::format("{} or {} {}", function.least, function.most, plural);
}

bool has_count(Lowering& lowering, const Function& function, base::SourceSpan span,
               std::size_t count) {
    if (count >= function.least && count <= function.most) return true;
    lowering.error(span, fmt::format("'{}' takes {}, not {}; write '{}'", function.name,
                                     expected_count(function), count, function.signature));
    return false;
}

/// The kind of the result where vectors are among the arguments; an error if they do not fit.
std::optional<VectorValue> common_kind(Lowering& lowering, const Function& function,
                                       base::SourceSpan span, std::span<const Value> arguments) {
    const VectorValue* kind = nullptr;
    for (const Value& it : arguments) {
        const auto* vector = std::get_if<VectorValue>(&it);
        if (!vector) continue;
        if (kind && !common_algebra(*kind, *vector)) {
            lowering.error(span, fmt::format("'{}' takes vectors of one size, not {} and {}",
                                             function.name, describe(*kind), describe(*vector)));
            return std::nullopt;
        }
        if (!kind || kind->algebra == Algebra::vector) kind = vector;
    }
    const bool plain = kind->algebra == Algebra::vector;
    if (function.on_vectors == OnVectors::none ||
        (function.on_vectors == OnVectors::plain && !plain)) {
        lowering.error(
            span,
            fmt::format("'{}' takes numbers{}, not {}; call it with the components", function.name,
                        function.on_vectors == OnVectors::none ? "" : " and vectors",
                        describe(*kind)));
        return std::nullopt;
    }
    return *kind;
}

Value each_component(Lowering& lowering, const Function& function, const VectorValue& kind,
                     std::span<const Value> arguments) {
    VectorValue result{kind.algebra, {}};
    std::vector<NodeId> parts(arguments.size());
    for (std::size_t i = 0; i < kind.components.size(); ++i) {
        std::ranges::transform(arguments, parts.begin(), [&](const Value& it) {
            const auto* number = std::get_if<NodeId>(&it);
            return number ? *number : std::get<VectorValue>(it).components[i];
        });
        result.components.push_back(function.build(lowering.field.graph, parts));
    }
    // Of these functions only `abs` is an isometry that leaves the length alone.
    if (function.name == "abs") result.orbit = kind.orbit;
    return result;
}

bool has_nothing(std::span<const Value> arguments) {
    return std::ranges::any_of(arguments, is_nothing);
}

/// Reports an argument that is neither a number nor a vector.
bool are_operands(Lowering& lowering, std::string_view function, base::SourceSpan span,
                  std::span<const Value> arguments) {
    for (const Value& it : arguments) {
        if (std::holds_alternative<NodeId>(it) || std::holds_alternative<VectorValue>(it)) continue;
        lowering.error(
            span, fmt::format("{} cannot be used as an argument of '{}'", describe(it), function));
        return false;
    }
    return true;
}

}  // namespace

Value apply(Lowering& lowering, const Function& function, base::SourceSpan span,
            std::span<const Value> arguments) {
    if (!has_count(lowering, function, span, arguments.size())) return Nothing{};
    if (has_nothing(arguments)) return Nothing{};
    if (function.name == "pow" && std::holds_alternative<VectorValue>(arguments[0])) {
        return raise(lowering, span, arguments[0], arguments[1]);
    }
    std::vector<NodeId> numbers;
    for (const Value& it : arguments) {
        if (const auto* number = std::get_if<NodeId>(&it)) numbers.push_back(*number);
    }
    if (numbers.size() == arguments.size()) return function.build(lowering.field.graph, numbers);
    const auto kind = common_kind(lowering, function, span, arguments);
    if (!kind) return Nothing{};
    return each_component(lowering, function, *kind, arguments);
}

Value apply(Lowering& lowering, const VectorFunction& function, base::SourceSpan span,
            std::span<const Value> arguments) {
    return function.build({lowering, function.name, span, arguments});
}

Value apply(Lowering& lowering, const FunctionValue& function, base::SourceSpan span,
            std::span<const Value> arguments) {
    if (has_nothing(arguments)) return Nothing{};
    if (function.definition) return call_user_function(lowering, function, span, arguments);
    if (is_in_prelude(function.name) || field::find_primitive(function.name)) {
        lowering.error(span, fmt::format("'{}' gives a field; it cannot be used as a function of "
                                         "numbers or vectors",
                                         function.name));
        return Nothing{};
    }
    if (!are_operands(lowering, function.name, span, arguments)) return Nothing{};
    if (const Function* of_numbers = find_function(function.name)) {
        return apply(lowering, *of_numbers, span, arguments);
    }
    const VectorFunction* of_vectors = find_vector_function(function.name);
    if (!of_vectors) {
        lowering.error(span, fmt::format("'{}' is called with fields; it cannot be used as a "
                                         "function of numbers or vectors",
                                         function.name));
        return Nothing{};
    }
    std::vector<Value> all(arguments.begin(), arguments.end());
    const auto required = static_cast<std::size_t>(
        std::ranges::count_if(of_vectors->slots, [](const Slot& slot) { return slot.required; }));
    if (all.size() < required || all.size() > of_vectors->slots.size()) {
        lowering.error(span,
                       fmt::format("'{}' cannot be called with {} argument{}; it is called '{}'",
                                   function.name, all.size(), all.size() == 1 ? "" : "s",
                                   of_vectors->signature));
        return Nothing{};
    }
    all.resize(of_vectors->slots.size());
    return apply(lowering, *of_vectors, span, all);
}

std::optional<FunctionValue> as_function(Lowering& lowering, ExpressionId id,
                                         std::string_view role) {
    const Value value = lower_expression(lowering, id);
    if (const auto* function = std::get_if<FunctionValue>(&value)) return *function;
    if (!is_nothing(value)) {
        lowering.error(lowering.span(id),
                       fmt::format("{} is no function, so it cannot be {}", describe(value), role));
    }
    return std::nullopt;
}

}  // namespace formula
