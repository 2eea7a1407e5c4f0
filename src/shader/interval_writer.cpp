// SPDX-License-Identifier: MIT
#include "shader/interval_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace shader {
namespace {

using graph::NodeId;
using graph::Op;

/// True if single precision has the number.
bool is_single(double value) {
    return std::abs(value) <= std::numeric_limits<float>::max() &&
           static_cast<double>(static_cast<float>(value)) == value;
}

std::string end_literal(float end) {
    if (std::isinf(end)) return end < 0 ? "zs_all().x" : "zs_all().y";
    return literal(end);
}

/// The neighbours of a number in single precision, or it alone if the program's precision has it.
std::string literal_interval(double value, Precision precision) {
    if (precision == Precision::doubled) {
        return fmt::format("real2({})", literal(value, precision));
    }
    if (is_single(value)) return fmt::format("real2({})", literal(value));
    constexpr double largest = std::numeric_limits<float>::max();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const auto nearest = static_cast<float>(std::clamp(value, -largest, largest));
    return fmt::format("real2({}, {})", end_literal(std::nextafter(nearest, -infinity)),
                       end_literal(std::nextafter(nearest, infinity)));
}

}  // namespace

std::string IntervalWriter::spelling(NodeId id) {
    const graph::Node& node = graph_[id];
    if (node.op == Op::constant) return literal_interval(node.value, values_.precision());
    if (node.op == Op::variable) return names_.at(static_cast<graph::VariableId>(node.symbol));
    if (!depends_[index(id)]) return fmt::format("interval_about({})", values_.expression(id));
    return written_.at(id);
}

std::string IntervalWriter::function(std::string_view name) {
    parts_.insert(fmt::format("interval/{}.glsl", name));
    return fmt::format("interval_{}", name);
}

std::string IntervalWriter::call(const graph::Node& node) {
    const std::string name = function(graph::facts(node.op).name);
    if (node.op == Op::mul) {
        const auto [a, b] = std::array{node.arguments[0], node.arguments[1]};
        if (a == b) return fmt::format("interval_square({})", spelling(a));
        for (const auto& [factor, other] : {std::pair{a, b}, std::pair{b, a}}) {
            if (graph_.is_constant(factor) && is_single(graph_[factor].value)) {
                return fmt::format("interval_scaled({}, {})", spelling(other),
                                   literal(graph_[factor].value));
            }
        }
    }
    std::vector<std::string> arguments;
    for (const NodeId argument : node.args()) arguments.push_back(spelling(argument));
    return fmt::format("{}({})", name, fmt::join(arguments, ", "));
}

std::string IntervalWriter::statements(NodeId root, std::string_view indent) {
    std::string text;
    for (const NodeId id : reachable(graph_, std::array{root})) {
        const graph::Node& node = graph_[id];
        if (node.args().empty() || !depends_[index(id)] || written_.contains(id)) continue;
        const std::string right = call(node);
        const std::string name = fmt::format("i{}", written_.size());
        text += fmt::format("{}real2 {} = {};\n", indent, name, right);
        written_[id] = name;
    }
    return text;
}

}  // namespace shader
