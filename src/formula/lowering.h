// SPDX-License-Identifier: MIT
// What the parts of lowering share: the values of expressions and the state of the work. Internal
// to the library.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/diagnostic.h"
#include "field/field.h"
#include "formula/ast.h"
#include "formula/node_facts.h"

namespace formula {

/// The value of an expression that has an error, or depends on one.
struct Nothing {};
struct TupleValue {
    std::vector<graph::NodeId> parts;
};
struct FieldValue {
    field::FieldId id{};
    std::size_t objects = 1;  ///< leaves below, repeated ones too
};
using Value = std::variant<Nothing, graph::NodeId, TupleValue, FieldValue>;

/// A name that the formula defines.
struct Binding {
    Value value;
    base::SourceSpan span;  ///< of the name where it is defined
    bool parameter = false;
    bool used = false;
};

struct Lowering {
    const Program& program;
    std::string_view text;
    field::Field field{};
    base::Diagnostics errors{};
    std::map<std::string, Binding, std::less<>> names{};
    NodeFacts facts{};
    bool too_large = false;  ///< a limit is exceeded and reported; nothing more is built

    void error(base::SourceSpan span, std::string message);
    base::SourceSpan span(ExpressionId id) const { return program[id].span; }
};

Value lower_expression(Lowering& lowering, ExpressionId id);

/// The value of an expression where only a number can stand; an error otherwise. `where` ends the
/// sentence "a field cannot be used ...".
std::optional<graph::NodeId> as_number(Lowering& lowering, ExpressionId id, std::string_view where);

/// The value of an expression where a field must stand: a number is the sheet where it is 0.
std::optional<FieldValue> as_field(Lowering& lowering, ExpressionId id);

Value lower_name(Lowering& lowering, std::string_view name, base::SourceSpan span);
Value lower_call(Lowering& lowering, const Call& call);
Value lower_intersection(Lowering& lowering, const Intersection& chain);
Value lower_union(Lowering& lowering, const Union& chain);

/// A slider with its values checked and a parameter of the graph; nothing if there was an error.
std::optional<field::Parameter> lower_parameter(Lowering& lowering,
                                                const ParameterDeclaration& declaration);

/// The number of a built-in name that may stand alone: a coordinate or a constant.
std::optional<graph::NodeId> built_in_number(Lowering& lowering, std::string_view name);

/// The error for a name that nothing has.
void report_unknown_name(Lowering& lowering, std::string_view name, base::SourceSpan span);

/// Reports the formula as too large where it is; called after each step that builds something.
void check_size(Lowering& lowering, const Value& value, base::SourceSpan span);

}  // namespace formula
