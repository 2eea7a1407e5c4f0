// SPDX-License-Identifier: MIT
#include "graph/operator.h"

#include <array>

namespace graph {
namespace {

constexpr std::array<OperatorFacts, operator_count> table = {{
    {"constant", 0, "", ""},
    {"variable", 0, "", ""},
    {"parameter", 0, "", ""},
#define OPERATOR(name, arity, glsl, file) {#name, arity, glsl, file},
#include "graph/operators.def"
}};

}  // namespace

const OperatorFacts& facts(Op op) { return table[static_cast<std::size_t>(op)]; }

}  // namespace graph
