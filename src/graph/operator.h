// SPDX-License-Identifier: MIT
// The scalar operators of the graph, from the table in operators.def.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace graph {

/// What a node does. The first three are leaves, the others are the rows of operators.def.
enum class Op : std::uint8_t {
    constant,
    variable,
    parameter,
#define OPERATOR(name, arity, glsl, file) name,
#include "graph/operators.def"
};

inline constexpr int max_arity = 4;

inline constexpr int operator_count = 3
#define OPERATOR(name, arity, glsl, file) +1
#include "graph/operators.def"
    ;

/// By operator; 0 for the leaves.
inline constexpr std::array<std::uint8_t, operator_count> arities = {
    0,
    0,
    0,
#define OPERATOR(name, arity, glsl, file) arity,
#include "graph/operators.def"
};
constexpr std::size_t arity(Op op) { return arities[static_cast<std::size_t>(op)]; }

/// A row of the table. For the leaves the arity is 0 and the spellings are empty.
struct OperatorFacts {
    std::string_view name;
    int arity;
    std::string_view glsl;
    std::string_view glsl_file;
};
const OperatorFacts& facts(Op op);

/// All operators with arguments, in the order of the table.
template <class Visit>
void for_each_operator(Visit visit) {
    for (int i = 3; i < operator_count; ++i) visit(static_cast<Op>(i));
}

}  // namespace graph
