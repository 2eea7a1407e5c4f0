// SPDX-License-Identifier: MIT
#include "formula/node_facts.h"

#include <array>
#include <cassert>
#include <utility>

#include "numeric/real.h"

namespace formula {
namespace {

using Values = std::array<double, graph::max_arity>;

template <class Operation, std::size_t... I>
double call(Operation operation, const Values& values, std::index_sequence<I...>) {
    return operation(values[I]...);
}

double evaluate(graph::Op op, const Values& values) {
    switch (op) {
        case graph::Op::constant:
        case graph::Op::variable:
        case graph::Op::parameter:
            break;
#define OPERATOR(name, arity, glsl, file)                                  \
    case graph::Op::name:                                                  \
        return call([](auto... a) { return numeric::name(a...); }, values, \
                    std::make_index_sequence<arity>());
#include "graph/operators.def"
    }
    assert(false);
    return 0;
}

}  // namespace

NodeFacts::Fact NodeFacts::find(const graph::Node& node) const {
    if (node.op == graph::Op::constant) return {false, true, node.value};
    if (node.op == graph::Op::variable) return {true, false, 0};
    if (node.op == graph::Op::parameter) return {false, false, 0};
    Fact fact;
    Values values{};
    std::size_t count = 0;
    for (const graph::NodeId argument : node.args()) {
        const Fact& part = facts_[graph::index(argument)];
        fact.point = fact.point || part.point;
        fact.constant = fact.constant && part.constant;
        values[count++] = part.value;
    }
    if (fact.constant) fact.value = evaluate(node.op, values);
    return fact;
}

const NodeFacts::Fact& NodeFacts::fact(const graph::Graph& graph, graph::NodeId id) {
    while (facts_.size() <= graph::index(id)) {
        facts_.push_back(find(graph[static_cast<graph::NodeId>(facts_.size())]));
    }
    return facts_[graph::index(id)];
}

bool NodeFacts::depends_on_point(const graph::Graph& graph, graph::NodeId id) {
    return fact(graph, id).point;
}

std::optional<double> NodeFacts::constant(const graph::Graph& graph, graph::NodeId id) {
    const Fact& it = fact(graph, id);
    if (!it.constant) return std::nullopt;
    return it.value;
}

}  // namespace formula
