// SPDX-License-Identifier: MIT
// What the parts of lowering share: the state of the work, and its steps. Internal to the library.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "base/diagnostic.h"
#include "field/field.h"
#include "formula/ast.h"
#include "formula/node_facts.h"
#include "formula/scope.h"
#include "formula/value.h"

namespace formula {

/// A text that is lowered: the user's, or one of the library's own definitions.
struct Source {
    const Program& program;
    std::string_view text;
    bool library = false;  ///< its places mean nothing to the user
};

/// A function whose body is being lowered.
struct Frame {
    const Frame* outer = nullptr;
    std::string_view function;
    const Source* caller = nullptr;
    base::SourceSpan call;  ///< in the caller's text
    std::size_t level = 1;  ///< of calls that are open, with this one
};

struct Lowering {
    const Source* source;  ///< of the expressions that are being lowered
    Scope* scope;          ///< of their names
    const Frame* frame = nullptr;
    field::Field field{};
    base::Diagnostics errors{};
    base::Diagnostics warnings{};
    std::map<field::FieldId, base::SourceSpan> comparisons{};  ///< those of Lowered
    NodeFacts facts{};
    std::set<std::pair<std::uint32_t, std::string>>
        reported{};               ///< places with what is wrong there
    std::size_t expressions = 0;  ///< lowered so far, those of functions at every call
    std::size_t depth = 0;        ///< levels of expressions that are open, through calls
    bool too_large = false;       ///< a limit is exceeded and reported; nothing more is built

    const Expression& operator[](ExpressionId id) const { return source->program[id]; }
    base::SourceSpan span(ExpressionId id) const { return source->program[id].span; }
    /// The line, from 1, of a place in the text that is being lowered.
    std::size_t line(base::SourceSpan span) const;

    /// Reports what is wrong at a place of the text that is being lowered. In the body of a
    /// function the calls that led there are added, and only the first of them is reported; what is
    /// wrong in a definition of the library is reported at the user's call of it.
    void error(base::SourceSpan span, std::string message);
    /// Of the user's text only, and without calls.
    void warning(base::SourceSpan span, std::string message);
};

/// A scope inside the one in use, for as long as it lives.
class InnerScope {
public:
    explicit InnerScope(Lowering& lowering) : lowering_(lowering), names{lowering.scope} {
        lowering.scope = &names;
    }
    ~InnerScope() { lowering_.scope = names.outer; }
    InnerScope(const InnerScope&) = delete;
    InnerScope& operator=(const InnerScope&) = delete;

private:
    Lowering& lowering_;

public:
    Scope names;
};

Value lower_expression(Lowering& lowering, ExpressionId id);

/// What to do with fields where numbers are calculated with or compared, and in other places.
inline constexpr std::string_view join_fields = "join fields with '|', '&' or '\\'";
inline constexpr std::string_view write_a_number = "write a number in its place";

/// The value of an expression where only a number can stand; an error otherwise. `where` ends the
/// sentence "a field cannot be used ...", after which stands what to do with it.
std::optional<graph::NodeId> as_number(Lowering& lowering, ExpressionId id, std::string_view where,
                                       std::string_view with_field = write_a_number);

/// The same of a value that the expression has been lowered to.
std::optional<graph::NodeId> number_of(Lowering& lowering, ExpressionId id, const Value& value,
                                       std::string_view where,
                                       std::string_view with_field = write_a_number);

/// The value of an expression where a field must stand: a number is the sheet where it is 0.
std::optional<FieldValue> as_field(Lowering& lowering, ExpressionId id);

/// Reports a function where a value must stand, if it is one.
bool report_function(Lowering& lowering, base::SourceSpan span, const Value& value);

/// A number that is known becomes a constant node.
graph::NodeId folded(Lowering& lowering, graph::NodeId id);

Value lower_name(Lowering& lowering, std::string_view name, base::SourceSpan span);
Value lower_call(Lowering& lowering, const Call& call);
Value lower_comparison(Lowering& lowering, const Comparison& comparison);
Value lower_if(Lowering& lowering, const Call& call);
Value lower_component(Lowering& lowering, const Component& component);
Value lower_iterate(Lowering& lowering, const Iterate& iterate, base::SourceSpan span);
Value lower_intersection(Lowering& lowering, const Intersection& chain);
Value lower_union(Lowering& lowering, const Union& chain);

/// Adds a parameter, with its values checked, to the field; a number or a vector, or nothing if
/// there was an error.
Value lower_parameter(Lowering& lowering, const ParameterDeclaration& declaration);

/// The number of a built-in name that may stand alone: a coordinate or a constant.
std::optional<graph::NodeId> built_in_number(Lowering& lowering, std::string_view name);

/// The error for a name that nothing has.
void report_unknown_name(Lowering& lowering, std::string_view name, base::SourceSpan span);

/// Reports the formula as too large where it is; called after each step that builds something.
void check_size(Lowering& lowering, const Value& value, base::SourceSpan span);

}  // namespace formula
