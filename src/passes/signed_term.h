// SPDX-License-Identifier: MIT
// Sums whose terms have signs.
#pragma once

#include "graph/graph.h"

namespace passes {

/// A term with its sign in front.
struct SignedTerm {
    graph::NodeId id{};
    bool negative = false;
};

/// The sum; the sign stays in front where it can.
inline SignedTerm sum(graph::Graph& graph, const SignedTerm& a, const SignedTerm& b) {
    using graph::Op;
    if (a.negative == b.negative) return {graph.apply(Op::add, a.id, b.id), a.negative};
    if (a.negative) return {graph.apply(Op::sub, b.id, a.id), false};
    return {graph.apply(Op::sub, a.id, b.id), false};
}

/// The term as a node.
inline graph::NodeId value_of(graph::Graph& graph, const SignedTerm& term) {
    return term.negative ? graph.apply(graph::Op::neg, term.id) : term.id;
}

}  // namespace passes
