// SPDX-License-Identifier: MIT
#include "eval/tape.h"

#include <cassert>

#include "eval/operators.h"

namespace eval {
namespace {

using numeric::Interval;

template <class T>
T run_instruction(const Tape::Instruction& instruction, const std::vector<T>& registers) {
    const auto& [op, result, arguments] = instruction;
    // A product of a number with itself is never negative, which the product of two unrelated
    // intervals does not know.
    if (op == graph::Op::mul && arguments[0] == arguments[1]) {
        return numeric::square(registers[arguments[0]]);
    }
    return apply(op, registers[arguments[0]], registers[arguments[1]], registers[arguments[2]],
                 registers[arguments[3]]);
}

template <class T>
void run(std::span<const Tape::Instruction> instructions, std::vector<T>& registers) {
    for (const Tape::Instruction& instruction : instructions) {
        registers[instruction.result] = run_instruction(instruction, registers);
    }
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

template <class T>
void load_parameters(const Tape& tape, std::span<const T> parameters, std::vector<T>& registers) {
    registers.resize(tape.register_count);
    std::size_t next = 0;
    for (const double constant : tape.constants) registers[next++] = T(constant);
    for (const graph::ParameterId id : tape.parameters) {
        assert(graph::index(id) < parameters.size());
        registers[next++] = parameters[graph::index(id)];
    }
    run(std::span(tape.instructions).first(tape.independent), registers);
}

template <class T>
void evaluate_loaded(const Tape& tape, std::span<const T> variables, std::span<T> roots,
                     std::vector<T>& registers) {
    assert(registers.size() == tape.register_count && roots.size() == tape.roots.size());
    std::size_t next = tape.uniform_count();
    for (const graph::VariableId id : tape.variables) {
        assert(graph::index(id) < variables.size());
        registers[next++] = variables[graph::index(id)];
    }
    run(std::span(tape.instructions).subspan(tape.independent), registers);
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
