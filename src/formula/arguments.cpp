// SPDX-License-Identifier: MIT
#include "formula/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "formula/built_in.h"
#include "formula/suggest.h"
#include "formula/user_function.h"

namespace formula {
namespace {

struct NamedArgument {
    std::string_view name;
    base::SourceSpan span;
    ExpressionId value{};
};

std::optional<NamedArgument> named(const Lowering& lowering, ExpressionId id) {
    const auto* comparison = std::get_if<Comparison>(&lowering[id].node);
    if (!comparison || comparison->relation != Relation::equal) return std::nullopt;
    const Expression& left = lowering[comparison->left];
    const auto* name = std::get_if<Name>(&left.node);
    if (!name) return std::nullopt;
    return NamedArgument{name->text, left.span, comparison->right};
}

/// How the function that is called here is called.
std::string signature_of(const Lowering& lowering, const Call& call) {
    const Binding* binding = find_binding(lowering.scope, call.function);
    const auto* function = binding ? std::get_if<FunctionValue>(&binding->value) : nullptr;
    return function && function->definition ? signature(*function) : signature(call.function);
}

std::string unknown_argument(const Lowering& lowering, const Call& call, std::string_view name,
                             std::span<const Slot> slots) {
    std::vector<std::string_view> names;
    for (const Slot& slot : slots) names.push_back(slot.name);
    const std::string_view meant = nearest(name, names);
    if (!meant.empty()) {
        return fmt::format("'{}' has no argument '{}'; did you mean '{}'?", call.function, name,
                           meant);
    }
    return fmt::format("'{}' has no argument '{}'; it is called '{}'", call.function, name,
                       signature_of(lowering, call));
}

/// Fills the slots of one call, argument by argument.
struct Binder {
    Lowering& lowering;
    const Call& call;
    std::span<const Slot> slots;
    Bound bound{};
    std::size_t next = 0;  ///< the slot of the next argument by place
    bool by_name = false;
    bool failed = false;

    void fail(base::SourceSpan span, std::string message) {
        lowering.error(span, std::move(message));
        failed = true;
    }

    void add_by_name(const NamedArgument& argument) {
        by_name = true;
        const auto slot = std::ranges::find(slots, argument.name, &Slot::name);
        if (slot == slots.end()) {
            return fail(argument.span, unknown_argument(lowering, call, argument.name, slots));
        }
        std::optional<ExpressionId>& place = bound[static_cast<std::size_t>(slot - slots.begin())];
        if (place) {
            return fail(argument.span, fmt::format("the argument '{}' of '{}' is given twice",
                                                   argument.name, call.function));
        }
        place = argument.value;
    }

    void add_by_place(ExpressionId id) {
        if (by_name) {
            return fail(lowering.span(id),
                        "an argument without a name cannot follow one with a name; name it too");
        }
        if (next < slots.size()) bound[next] = id;
        ++next;
    }

    bool has_slot(const NamedArgument& argument) const {
        return std::ranges::find(slots, argument.name, &Slot::name) != slots.end();
    }

    void check_count() {
        if (next > slots.size()) {
            fail(call.name, fmt::format("'{}' takes at most {} argument{}, not {}; it is called "
                                        "'{}'",
                                        call.function, slots.size(), slots.size() == 1 ? "" : "s",
                                        next, signature_of(lowering, call)));
        }
        for (std::size_t i = 0; i < slots.size() && !failed; ++i) {
            if (bound[i] || !slots[i].required) continue;
            fail(call.name, fmt::format("an argument of '{}' is missing; it is called '{}'",
                                        call.function, signature_of(lowering, call)));
        }
    }
};

/// `may_be_surface` says of a name that no slot has whether `name = ...` is an equation.
template <class Test>
std::optional<Bound> bind_unless(Lowering& lowering, const Call& call, std::span<const Slot> slots,
                                 Test may_be_surface) {
    Binder binder{lowering, call, slots, Bound(slots.size())};
    for (const ExpressionId id : call.arguments) {
        const std::optional<NamedArgument> argument = named(lowering, id);
        if (argument && (binder.has_slot(*argument) || !may_be_surface(argument->name))) {
            binder.add_by_name(*argument);
        } else {
            binder.add_by_place(id);
        }
    }
    binder.check_count();
    if (binder.failed) {
        lower_arguments(lowering, call);
        return std::nullopt;
    }
    return std::move(binder.bound);
}

}  // namespace

std::optional<Bound> bind(Lowering& lowering, const Call& call, std::span<const Slot> slots,
                          bool of_fields) {
    return bind_unless(lowering, call, slots, [&](std::string_view) { return of_fields; });
}

std::optional<Bound> bind_to_user_function(Lowering& lowering, const Call& call,
                                           std::span<const Slot> slots) {
    return bind_unless(lowering, call, slots, is_coordinate);
}

void lower_arguments(Lowering& lowering, const Call& call) {
    for (const ExpressionId id : call.arguments) {
        const std::optional<NamedArgument> argument = named(lowering, id);
        const bool surface = argument && is_coordinate(argument->name);
        lower_expression(lowering, argument && !surface ? argument->value : id);
    }
}

std::optional<std::vector<graph::NodeId>> uniform_components(Lowering& lowering, const Call& call,
                                                             std::string_view argument,
                                                             ExpressionId id,
                                                             std::size_t components,
                                                             bool may_be_one) {
    const std::string subject = fmt::format("the argument '{}' of '{}'", argument, call.function);
    const Value value = lower_expression(lowering, id);
    if (is_nothing(value) || report_function(lowering, lowering.span(id), value)) {
        return std::nullopt;
    }
    std::vector<graph::NodeId> parts;
    if (const auto* number = std::get_if<graph::NodeId>(&value)) parts = {*number};
    if (const auto* tuple = std::get_if<VectorValue>(&value)) parts = tuple->components;
    const base::SourceSpan span = lowering.span(id);
    if (std::holds_alternative<FieldValue>(value)) {
        lowering.error(span, fmt::format("{} is a {}, not a field", subject,
                                         components == 1 ? "number" : "tuple"));
        return std::nullopt;
    }
    if (parts.size() != components && !(may_be_one && parts.size() == 1)) {
        lowering.error(span, components == 1 ? fmt::format("{} is one number, not a tuple", subject)
                                             : fmt::format("{} is a tuple of {} numbers, not {}",
                                                           subject, components, parts.size()));
        return std::nullopt;
    }
    for (const graph::NodeId part : parts) {
        if (lowering.facts.depends_on_point(lowering.field.graph, part)) {
            lowering.error(span, fmt::format("{} must not depend on x, y or z", subject));
            return std::nullopt;
        }
        const std::optional<double> known = lowering.facts.constant(lowering.field.graph, part);
        if (known && !std::isfinite(*known)) {
            lowering.error(span, fmt::format("{} is not a finite number", subject));
            return std::nullopt;
        }
    }
    return parts;
}

}  // namespace formula
