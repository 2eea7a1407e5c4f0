// SPDX-License-Identifier: MIT
// From a graph to a tape: order, and allocation of registers by linear scan (Poletto & Sarkar,
// "Linear scan register allocation", 1999).
#include <algorithm>
#include <limits>
#include <unordered_map>

#include "eval/tape.h"

namespace eval {
namespace {

using graph::Graph;
using graph::Node;
using graph::NodeId;
using graph::Op;

constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

/// A node that the roots need. Places are numbers in the order of evaluation.
struct Step {
    const Node* node = nullptr;
    std::array<std::uint32_t, graph::max_arity> arguments{};  ///< places
    bool depends = false;                                     ///< on a variable
    std::uint32_t last_user = nowhere;                        ///< a place; nowhere: never released
    std::uint32_t where = 0;                                  ///< the register

    bool is_leaf() const { return node->args().empty(); }
    std::span<const std::uint32_t> args() const {
        return std::span(arguments).first(node->args().size());
    }
};

/// All steps in order, and the places of the roots. Depth first, so that what is computed is used
/// soon.
struct Order {
    std::vector<Step> steps;
    std::vector<std::uint32_t> roots;
};

Step finished_step(const Node& node, const std::unordered_map<NodeId, std::uint32_t>& places,
                   std::span<const Step> steps) {
    Step step{.node = &node, .depends = node.op == Op::variable};
    for (std::size_t i = 0; i < node.args().size(); ++i) {
        step.arguments[i] = places.at(node.args()[i]);
        step.depends = step.depends || steps[step.arguments[i]].depends;
    }
    return step;
}

Order order_for(const Graph& graph, std::span<const NodeId> roots) {
    struct Visit {
        NodeId id;
        std::size_t next_argument = 0;
    };
    Order order;
    std::unordered_map<NodeId, std::uint32_t> places;  // nowhere: on the path
    std::vector<Visit> path;
    for (const NodeId root : roots) {
        if (places.try_emplace(root, nowhere).second) path.push_back({root});
        while (!path.empty()) {
            Visit& visit = path.back();
            const Node& node = graph[visit.id];
            if (visit.next_argument < node.args().size()) {
                const NodeId argument = node.args()[visit.next_argument++];
                if (places.try_emplace(argument, nowhere).second) path.push_back({argument});
                continue;
            }
            order.steps.push_back(finished_step(node, places, order.steps));
            places[visit.id] = static_cast<std::uint32_t>(order.steps.size() - 1);
            path.pop_back();
        }
        order.roots.push_back(places.at(root));
    }
    return order;
}

void find_last_users(Order& order) {
    for (std::size_t i = 0; i < order.steps.size(); ++i) {
        for (const std::uint32_t argument : order.steps[i].args()) {
            order.steps[argument].last_user = static_cast<std::uint32_t>(i);
        }
    }
    for (const std::uint32_t root : order.roots) order.steps[root].last_user = nowhere;
}

void append_instruction(Tape& tape, const Order& order, const Step& step) {
    Tape::Instruction instruction{.op = step.node->op, .result = step.where};
    std::ranges::transform(step.args(), instruction.arguments.begin(),
                           [&](std::uint32_t place) { return order.steps[place].where; });
    tape.instructions.push_back(instruction);
}

/// Gives each leaf of this kind a register of its own and calls `note` for it.
template <class Note>
void place_leaves(Order& order, Op kind, std::size_t& register_count, Note note) {
    for (Step& step : order.steps) {
        if (step.node->op != kind) continue;
        step.where = static_cast<std::uint32_t>(register_count++);
        note(*step.node);
    }
}

/// Registers for the results of all instructions that depend on variables, each used again after
/// the last user of its content; an instruction may write over its own arguments.
void place_dependent(Order& order, Tape& tape) {
    find_last_users(order);
    std::vector<std::uint32_t> free;
    for (std::size_t i = 0; i < order.steps.size(); ++i) {
        Step& step = order.steps[i];
        if (!step.depends || step.is_leaf()) continue;
        for (const std::uint32_t place : step.args()) {
            Step& argument = order.steps[place];
            if (argument.last_user != i || !argument.depends) continue;
            free.push_back(argument.where);
            argument.last_user = nowhere;  // only once, if it is an argument twice
        }
        if (free.empty()) free.push_back(static_cast<std::uint32_t>(tape.register_count++));
        step.where = free.back();
        free.pop_back();
        append_instruction(tape, order, step);
    }
}

}  // namespace

Tape make_tape(const graph::Graph& graph, std::span<const graph::NodeId> roots) {
    Order order = order_for(graph, roots);
    Tape tape;
    place_leaves(order, Op::constant, tape.register_count,
                 [&](const Node& node) { tape.constants.push_back(node.value); });
    place_leaves(order, Op::parameter, tape.register_count, [&](const Node& node) {
        tape.parameters.push_back(static_cast<graph::ParameterId>(node.symbol));
    });
    for (Step& step : order.steps) {
        if (step.depends || step.is_leaf()) continue;
        step.where = static_cast<std::uint32_t>(tape.register_count++);
        append_instruction(tape, order, step);
    }
    tape.independent = tape.instructions.size();
    place_leaves(order, Op::variable, tape.register_count, [&](const Node& node) {
        tape.variables.push_back(static_cast<graph::VariableId>(node.symbol));
    });
    place_dependent(order, tape);
    for (const std::uint32_t root : order.roots) tape.roots.push_back(order.steps[root].where);
    return tape;
}

}  // namespace eval
