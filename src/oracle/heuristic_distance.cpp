// SPDX-License-Identifier: MIT
#include "oracle/heuristic_distance.h"

#include <array>
#include <cmath>

namespace oracle {
namespace {

std::vector<double> loaded(const eval::Tape& tape, const std::vector<double>& parameters) {
    std::vector<double> registers;
    eval::load_parameters<double>(tape, parameters, registers);
    return registers;
}

}  // namespace

HeuristicDistance::HeuristicDistance(const Shape& shape)
    : shape_(shape), variables_(shape.variable_count), values_(shape), gradients_(shape) {
    std::size_t most = 3;
    for (const Loop& loop : shape.loops) {
        const auto with = [&](const eval::Tape& tape) { return loaded(tape, shape.parameters); };
        loop_registers_.push_back({with(loop.point), with(loop.start), with(loop.step),
                                   with(loop.escape), with(loop.distance)});
        most = std::max(most, loop.state.size());
    }
    results_.resize(most);
}

void HeuristicDistance::run(const eval::Tape& tape, std::vector<double>& registers,
                            std::span<double> roots) {
    eval::evaluate_loaded<double>(tape, variables_, roots, registers);
}

double HeuristicDistance::loop(std::size_t number) {
    const Loop& loop = shape_.loops[number];
    LoopRegisters& registers = loop_registers_[number];
    const std::span<double> state = std::span(results_).first(loop.state.size());
    const auto set_state = [&] {
        for (std::size_t i = 0; i < state.size(); ++i) {
            variables_[graph::index(loop.state[i])] = state[i];
        }
    };
    run(loop.point, registers.point, std::span(results_).first(3));
    std::copy_n(results_.begin(), 3, variables_.begin());
    run(loop.start, registers.start, state);
    set_state();
    double answer = 0;
    const std::span<double> one(&answer, 1);
    const auto escaped = [&] {
        if (!loop.escapes) return false;
        run(loop.escape, registers.escape, one);
        return answer > 0;
    };
    bool out = escaped();
    for (double turn = 0; turn < loop.limit && !out; ++turn) {
        run(loop.step, registers.step, state);
        set_state();
        out = escaped();
    }
    if (loop.escapes && !out) {
        answer = -numeric::infinity;
    } else {
        run(loop.distance, registers.distance, one);
        answer = outside_if_undefined(answer);
        if (loop.escapes) answer = std::max(answer, 1e-300);  // outside, however near
    }
    for (int i = 0; i < 3; ++i) variables_[static_cast<std::size_t>(i)] = point_[i];
    return answer;
}

double HeuristicDistance::formula(const Solid& node, What what) {
    const double value = outside_if_undefined(values_.expression(node.source));
    if (what == What::value || node.distance || std::isinf(value)) return value;
    using numeric::Dual;
    gradients_.move_to({Dual<double>::variable(point_.x, 0), Dual<double>::variable(point_.y, 1),
                        Dual<double>::variable(point_.z, 2)});
    const auto& g = gradients_.expression(node.source).gradient;
    const double steepness = std::hypot(g[0], g[1], g[2]);
    return steepness > 0 && std::isfinite(steepness) ? 0.5 * value / steepness : value;
}

double HeuristicDistance::blend(const Solid& node) {
    std::vector<double> operands;
    for (const std::size_t operand : node.operands) operands.push_back(of(operand, What::value));
    return values_.mix(node, operands);
}

double HeuristicDistance::of(std::size_t solid, What what) {
    const Solid& node = shape_.solids[solid];
    const auto operand = [&](std::size_t i) { return of(node.operands[i], what); };
    switch (node.what) {
        case Solid::What::formula:
            return formula(node, what);
        case Solid::What::loop:
            return loop(node.source);
        case Solid::What::least:
            return std::min(operand(0), operand(1));
        case Solid::What::most:
            return std::max(operand(0), operand(1));
        case Solid::What::complement:
            return -operand(0);
        case Solid::What::blend:
            return blend(node);
    }
    return 0;
}

double HeuristicDistance::operator()(std::size_t solid, glm::dvec3 point) {
    point_ = point;
    for (int i = 0; i < 3; ++i) variables_[static_cast<std::size_t>(i)] = point[i];
    values_.move_to({point.x, point.y, point.z});
    return of(solid, What::distance);
}

std::size_t HeuristicDistance::operand(std::size_t solid, glm::dvec3 point) {
    const Solid& node = shape_.solids[solid];
    if (node.operands.size() < 2) return node.operands[0];
    const double a = (*this)(node.operands[0], point), b = (*this)(node.operands[1], point);
    const bool second = node.what == Solid::What::least  ? b < a
                        : node.what == Solid::What::most ? b > a
                                                         : std::abs(b) < std::abs(a);
    return node.operands[second ? 1 : 0];
}

std::size_t HeuristicDistance::leaf(std::size_t solid, glm::dvec3 point) {
    while (!shape_.solids[solid].operands.empty()) solid = operand(solid, point);
    return solid;
}

}  // namespace oracle
