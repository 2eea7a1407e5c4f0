// SPDX-License-Identifier: MIT
#include "eval/tape.h"

#include <cassert>

#include "eval/operators.h"

namespace eval {
namespace {

using numeric::Interval;

/// Appends the instructions for those operators of `order` that do, or do not, depend on variables.
void append_instructions(const graph::Graph& graph, std::span<const graph::NodeId> order,
                         const std::vector<bool>& depends, bool dependent,
                         std::vector<std::uint32_t>& register_of, Tape& tape) {
    const std::size_t first = tape.first_result();
    for (const graph::NodeId id : order) {
        const graph::Node& node = graph[id];
        if (node.args().empty() || depends[graph::index(id)] != dependent) continue;
        Tape::Instruction instruction{.op = node.op};
        for (std::size_t i = 0; i < node.args().size(); ++i) {
            instruction.arguments[i] = register_of[graph::index(node.args()[i])];
        }
        register_of[graph::index(id)] =
            static_cast<std::uint32_t>(first + tape.instructions.size());
        tape.instructions.push_back(instruction);
    }
}

template <class T>
T run_instruction(const Tape::Instruction& instruction, const std::vector<T>& registers) {
    const auto& [op, arguments] = instruction;
    // A product of a number with itself is never negative, which the product of two unrelated
    // intervals does not know.
    if (op == graph::Op::mul && arguments[0] == arguments[1]) {
        return numeric::square(registers[arguments[0]]);
    }
    return apply(op, registers[arguments[0]], registers[arguments[1]], registers[arguments[2]],
                 registers[arguments[3]]);
}

template <class T>
T evaluate_once(const graph::Graph& graph, graph::NodeId root, const std::array<T, 3>& place,
                std::span<const double> parameters) {
    const Tape tape = make_tape(graph, std::array{root});
    std::vector<T> variables(graph.variable_count(), T(0.0));
    for (std::size_t i = 0; i < 3; ++i) variables[i] = place[i];
    std::vector<T> values(graph.parameter_count(), T(0.0));
    for (std::size_t i = 0; i < parameters.size() && i < values.size(); ++i) {
        values[i] = T(parameters[i]);
    }
    std::vector<T> scratch;
    T result(0.0);
    evaluate<T>(tape, variables, values, std::span<T>(&result, 1), scratch);
    return result;
}

}  // namespace

Tape make_tape(const graph::Graph& graph, std::span<const graph::NodeId> roots) {
    const std::vector<graph::NodeId> order = graph::reachable(graph, roots);
    const std::vector<bool> depends = graph::depends_on_variables(graph);
    std::vector<std::uint32_t> register_of(graph.size(), 0);
    Tape tape;
    std::uint32_t next = 0;
    for (const graph::Op leaf : {graph::Op::constant, graph::Op::parameter, graph::Op::variable}) {
        for (const graph::NodeId id : order) {
            const graph::Node& node = graph[id];
            if (node.op != leaf) continue;
            if (leaf == graph::Op::constant) tape.constants.push_back(node.value);
            if (leaf == graph::Op::parameter) {
                tape.parameters.push_back(static_cast<graph::ParameterId>(node.symbol));
            }
            if (leaf == graph::Op::variable) {
                tape.variables.push_back(static_cast<graph::VariableId>(node.symbol));
            }
            register_of[graph::index(id)] = next++;
        }
    }
    append_instructions(graph, order, depends, false, register_of, tape);
    tape.independent = tape.instructions.size();
    append_instructions(graph, order, depends, true, register_of, tape);
    for (const graph::NodeId root : roots) tape.roots.push_back(register_of[graph::index(root)]);
    return tape;
}

template <class T>
void load_parameters(const Tape& tape, std::span<const T> parameters, std::vector<T>& registers) {
    registers.resize(tape.register_count());
    std::size_t next = 0;
    for (const double constant : tape.constants) registers[next++] = T(constant);
    for (const graph::ParameterId id : tape.parameters) {
        assert(graph::index(id) < parameters.size());
        registers[next++] = parameters[graph::index(id)];
    }
    const std::size_t first = tape.first_result();
    for (std::size_t i = 0; i < tape.independent; ++i) {
        registers[first + i] = run_instruction(tape.instructions[i], registers);
    }
}

template <class T>
void evaluate_loaded(const Tape& tape, std::span<const T> variables, std::span<T> roots,
                     std::vector<T>& registers) {
    assert(registers.size() == tape.register_count() && roots.size() == tape.roots.size());
    std::size_t next = tape.constants.size() + tape.parameters.size();
    for (const graph::VariableId id : tape.variables) {
        assert(graph::index(id) < variables.size());
        registers[next++] = variables[graph::index(id)];
    }
    const std::size_t first = tape.first_result();
    for (std::size_t i = tape.independent; i < tape.instructions.size(); ++i) {
        registers[first + i] = run_instruction(tape.instructions[i], registers);
    }
    for (std::size_t i = 0; i < roots.size(); ++i) roots[i] = registers[tape.roots[i]];
}

template <class T>
void evaluate(const Tape& tape, std::span<const T> variables, std::span<const T> parameters,
              std::span<T> roots, std::vector<T>& scratch) {
    load_parameters(tape, parameters, scratch);
    evaluate_loaded(tape, variables, roots, scratch);
}

double evaluate(const graph::Graph& graph, graph::NodeId root, glm::dvec3 point,
                std::span<const double> parameters) {
    return evaluate_once<double>(graph, root, {point.x, point.y, point.z}, parameters);
}

Interval enclose(const graph::Graph& graph, graph::NodeId root, const std::array<Interval, 3>& box,
                 std::span<const double> parameters) {
    return evaluate_once<Interval>(graph, root, box, parameters);
}

#define ZEROSET_INSTANTIATE(T)                                                                     \
    template void load_parameters(const Tape&, std::span<const T>, std::vector<T>&);               \
    template void evaluate_loaded(const Tape&, std::span<const T>, std::span<T>, std::vector<T>&); \
    template void evaluate(const Tape&, std::span<const T>, std::span<const T>, std::span<T>,      \
                           std::vector<T>&);
ZEROSET_INSTANTIATE(double)
ZEROSET_INSTANTIATE(Interval)
ZEROSET_INSTANTIATE(numeric::Dual<double>)
ZEROSET_INSTANTIATE(numeric::SecondOrder<double>)
ZEROSET_INSTANTIATE(numeric::Dual<Interval>)
ZEROSET_INSTANTIATE(numeric::SecondOrder<Interval>)
using RayJet = numeric::SecondOrder<double, 1>;
using RayIntervalJet = numeric::SecondOrder<Interval, 1>;
ZEROSET_INSTANTIATE(RayJet)
ZEROSET_INSTANTIATE(RayIntervalJet)
#undef ZEROSET_INSTANTIATE

}  // namespace eval
