// SPDX-License-Identifier: MIT
#include "formula/lower.h"

#include <fmt/format.h>

#include <utility>

#include "formula/built_in.h"
#include "formula/lowering.h"
#include "formula/parse.h"
#include "formula/report.h"
#include "formula/user_function.h"

namespace formula {
namespace {

/// True if the name may be defined where the span is; reports why not.
bool may_define(Lowering& lowering, const std::string& name, base::SourceSpan span) {
    if (is_coordinate(name)) {
        lowering.error(span, fmt::format("'{}' is a coordinate and cannot be redefined", name));
        return false;
    }
    const auto found = lowering.scope->names.find(name);
    if (found == lowering.scope->names.end()) return true;
    lowering.error(span, fmt::format("'{}' is already defined on line {}; choose another name",
                                     name, lowering.line(found->second.span)));
    return false;
}

void define(Lowering& lowering, const Definition& definition) {
    Value value = definition.parameters ? define_function(lowering, definition)
                                        : lower_expression(lowering, definition.value);
    if (!may_define(lowering, definition.name, definition.span)) return;
    lowering.scope->set(definition.name, std::move(value), definition.span, Role::definition);
}

void define(Lowering& lowering, const ParameterDeclaration& declaration) {
    Value value = lower_parameter(lowering, declaration);
    if (declaration.name.empty()) return;
    if (!may_define(lowering, declaration.name, declaration.span)) return;
    lowering.scope->set(declaration.name, std::move(value), declaration.span, Role::slider);
}

void warn_of_unused_names(Lowering& lowering) {
    for (const auto& [name, binding] : lowering.scope->names) {
        if (binding.used) continue;
        const bool slider = binding.role == Role::slider;
        lowering.warning(binding.span, fmt::format("the {} '{}' is never used",
                                                   slider ? "parameter" : "definition", name));
    }
}

}  // namespace

base::Result<Lowered> lower(const Program& program, std::string_view text) {
    const Source source{program, text};
    Scope scope;
    Lowering lowering{&source, &scope};
    for (const Statement& statement : program.statements) {
        std::visit([&](const auto& it) { define(lowering, it); }, statement);
    }
    const std::optional<FieldValue> root = as_field(lowering, program.result);
    if (!root || base::has_errors(lowering.errors)) return in_order(std::move(lowering.errors));
    lowering.field.root = root->id;
    warn_of_unused_names(lowering);
    return Lowered{std::move(lowering.field), in_order(std::move(lowering.warnings)),
                   lowering.span(program.result), std::move(lowering.comparisons)};
}

base::Result<Lowered> understand(std::string_view text) {
    Reading reading = read(text);
    if (!reading.program) return std::move(reading.errors);
    base::Result<Lowered> lowered = lower(*reading.program, text);
    if (reading.errors.empty()) return lowered;
    base::Diagnostics errors = std::move(reading.errors);
    for (base::Diagnostic& it : lowered.problems()) errors.push_back(std::move(it));
    return in_order(std::move(errors));
}

}  // namespace formula
