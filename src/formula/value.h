// SPDX-License-Identifier: MIT
// What an expression can be. Types are inferred and never written. Internal to the library.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "field/field.h"
#include "formula/ast.h"

namespace formula {

struct Scope;
struct Source;

/// The value of an expression that has an error, or depends on one. Nothing more is reported about
/// what comes of it.
struct Nothing {};

/// How vectors are multiplied: not at all, or as numbers of two, four or three components. The real
/// part of a complex number or a quaternion is the first component.
enum class Algebra { vector, complex, quaternion, triplex };

/// How the size of a value v grows with the state of the iteration around it, from which a distance
/// estimate is derived. All are nodes that are independent of where the value is used.
struct Orbit {
    graph::NodeId stretch{};  ///< an upper bound of |dv/dp|, p the point, if the state's is one
    graph::NodeId degree{};   ///< |v| grows like |state|^degree; 0 for what is no part of the state
    graph::NodeId scale{};    ///< and this is the factor in front, an upper bound
    /// Where `stretch` leaves out that space is stretched more in some directions: counting that at
    /// every turn, and so more than there is in all. None if nothing is left out.
    std::optional<graph::NodeId> across{};
};

/// Two to four numbers. What no rule of orbit.h describes has no `orbit`.
struct VectorValue {
    Algebra algebra = Algebra::vector;
    std::vector<graph::NodeId> components;
    std::optional<Orbit> orbit{};
};

struct FieldValue {
    field::FieldId id{};
    std::size_t objects = 1;  ///< leaves below, repeated ones too
};

/// What can be called, by its name alone.
struct FunctionValue {
    std::string name;
    const Definition* definition = nullptr;  ///< none for what is built in
    const Source* source = nullptr;          ///< of the definition
    Scope* scope = nullptr;                  ///< where the definition stands
    std::size_t visible = 0;                 ///< how many names of that scope it knows
};

using Value = std::variant<Nothing, graph::NodeId, VectorValue, FieldValue, FunctionValue>;

inline bool is_nothing(const Value& value) { return std::holds_alternative<Nothing>(value); }

/// What a value is, in words: `a number`, `a vector of 3`, `a quaternion`, `a field`.
std::string describe(const Value& value);

}  // namespace formula
