// SPDX-License-Identifier: MIT
// What a formula's text says, as a tree: expressions by number in one arena, so that nothing about
// them recurses unless it wants to. Chains are flat lists, and signs and brackets leave no nodes
// but a Negate, so that long formulas make no tall trees.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/source_span.h"
#include "field/parameter.h"

namespace formula {

enum class ExpressionId : std::uint32_t {};
constexpr std::size_t index(ExpressionId id) { return static_cast<std::size_t>(id); }

struct Number {
    double value = 0;
};
struct Name {
    std::string text;
};
/// -a
struct Negate {
    ExpressionId operand{};
};

/// How an operand of a chain joins those before it; of the first one it means nothing.
enum class Joint { plus, minus, times, over, implied_times, both, without, either };

struct Operand {
    Joint joint = Joint::plus;
    ExpressionId expression{};
};
/// a + b - c ..., from the left.
struct Sum {
    std::vector<Operand> operands;
};
/// a * b / c ..., from the left; implied products too.
struct Product {
    std::vector<Operand> operands;
};
/// a & b \ c ..., from the left.
struct Intersection {
    std::vector<Operand> operands;
};
/// a | b | c ...
struct Union {
    std::vector<Operand> operands;
};

struct Power {
    ExpressionId base{}, exponent{};
};

enum class Relation { equal, less_equal, less, greater_equal, greater };
/// The sign, such as `<=`.
std::string_view spelling(Relation relation);

struct Comparison {
    Relation relation = Relation::equal;
    ExpressionId left{}, right{};
};

/// f(a, b). An argument by name, `c = ...`, is a Comparison here: only the function that is called
/// tells the two apart.
struct Call {
    std::string function;
    base::SourceSpan name;
    std::vector<ExpressionId> arguments;
};
/// (a, b, c), two parts or more.
struct Tuple {
    std::vector<ExpressionId> parts;
};
/// a.x, or several components at once: a.xy
struct Component {
    ExpressionId operand{};
    std::string letters;    ///< of x, y, z, w; one or more
    base::SourceSpan name;  ///< of the letters
};

/// name = value, inside an iteration.
struct Assignment {
    std::string name;
    base::SourceSpan span;  ///< of the name
    ExpressionId value{};
};
/// iterate q = start, s = start for limit until a > b: body
struct Iterate {
    std::vector<Assignment> state;         ///< what is carried from turn to turn, with its start
    ExpressionId limit{};                  ///< turns at most
    std::optional<ExpressionId> until;     ///< Comparisons, maybe joined
    std::vector<Assignment> body;          ///< in order: state and names of the turn
    std::optional<ExpressionId> distance;  ///< `distance = ...` in the body: of the last state
    std::optional<ExpressionId> colour;    ///< `colour = ...` likewise
};
/// Stands for what could not be parsed; its error is reported already.
struct Broken {};

using ExpressionNode = std::variant<Number, Name, Negate, Sum, Product, Intersection, Union, Power,
                                    Comparison, Call, Tuple, Component, Iterate, Broken>;

struct Expression {
    ExpressionNode node;
    base::SourceSpan span;     ///< with the brackets around it
    std::uint32_t height = 1;  ///< levels of the tree below and including this one
};

/// What a function that the user defines is called with.
struct FunctionParameter {
    std::string name;
    base::SourceSpan span;                ///< of the name
    std::optional<ExpressionId> initial;  ///< where it may be left out
};

/// name = value, or name(a, b = initial) = value
struct Definition {
    std::string name;
    base::SourceSpan span;  ///< of the name
    ExpressionId value{};
    std::optional<std::vector<FunctionParameter>> parameters;  ///< of a function
};

using ParameterType = field::ParameterType;
/// The word; the middle four are written in a declaration.
std::string_view spelling(ParameterType type);

/// param name = initial in [minimum, maximum] step s angle "label" group "g" tooltip "t"
struct ParameterDeclaration {
    std::string name;
    base::SourceSpan span;  ///< of the name
    ParameterType type = ParameterType::real;
    base::SourceSpan type_span;  ///< of the word that says the type; the name's if none does
    /// A number or a tuple; of a choice the index as a Number (from 0), of a toggle 1 or 0.
    ExpressionId initial{};
    std::optional<std::array<ExpressionId, 2>> range;
    std::vector<std::string> choices;  ///< of a choice: in ["a", "b"]
    std::optional<ExpressionId> step;
    std::optional<std::string> label;
    std::optional<std::string> group;
    std::optional<std::string> tooltip;
};

using Statement = std::variant<Definition, ParameterDeclaration>;

/// A whole formula. Every argument of an expression has a smaller number than the expression.
struct Program {
    std::vector<Expression> expressions;
    std::vector<Statement> statements;
    ExpressionId result{};

    /// Adds an expression and finds its height.
    ExpressionId add(ExpressionNode node, base::SourceSpan span);
    const Expression& operator[](ExpressionId id) const { return expressions[index(id)]; }
};

/// The direct parts of an expression, from left to right.
std::vector<ExpressionId> parts(const ExpressionNode& node);

}  // namespace formula
