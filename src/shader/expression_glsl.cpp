// SPDX-License-Identifier: MIT
#include "shader/expression_glsl.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "graph/print.h"
#include "passes/spell_out_lengths.h"

namespace shader {

using graph::NodeId;
using graph::Op;

std::string literal(double value, Precision precision) {
    const bool doubled = precision == Precision::doubled;
    const double largest =
        doubled ? std::numeric_limits<double>::max() : std::numeric_limits<float>::max();
    std::string text = graph::shortest(std::clamp(value, -largest, largest));
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    if (doubled) text += "lf";
    return text.starts_with('-') ? '(' + text + ')' : text;
}

std::string FieldValues::place(const FieldValue& value) {
    list_.push_back(value);
    const std::size_t i = list_.size() - 1;
    return fmt::format("field_values[{}].{}", i / 4, "xyzw"[i % 4]);
}

std::string FieldValues::expression(NodeId node) {
    const auto known = places_.find(node);
    if (known != places_.end()) return known->second;
    expressions_.push_back(node);
    return places_[node] = place({FieldValue::What::expression, {}, {}});
}

std::string ExpressionWriter::spelling(NodeId id) {
    const graph::Node& node = graph_[id];
    if (node.op == Op::constant) return literal(node.value, values_.precision());
    if (node.op == Op::variable) return names_.at(static_cast<graph::VariableId>(node.symbol));
    if (!depends_[index(id)]) return values_.expression(id);
    return written_.at(id);
}

std::string ExpressionWriter::function(const graph::Node& node) {
    const graph::OperatorFacts& facts = graph::facts(node.op);
    // Of a choice only what is compared matters: what is chosen is handed on as it is.
    const std::span<const NodeId> asked =
        node.op == Op::select_less ? node.args().first(2) : node.args();
    const bool never_nan = may_be_nan_ && std::ranges::none_of(asked, [&](NodeId a) {
                               return (*may_be_nan_)[index(a)];
                           });
    const auto part = [&](std::string_view file) {
        if (!file.empty()) operator_parts_.insert(fmt::format("operator/{}.glsl", file));
    };
    if (node.op == Op::sqrt && passes::is_sum_of_squares(graph_, node.arguments[0])) return "sqrt";
    if (never_nan && (node.op == Op::min || node.op == Op::max)) {
        part("lesser");
        return node.op == Op::min ? "zs_lesser" : "zs_greater";
    }
    if (never_nan && node.op == Op::select_less) {
        part("choose");
        return "zs_choose";
    }
    if (never_nan && node.op == Op::sign) return "sign";
    part(facts.glsl_file);
    return std::string(facts.glsl);
}

std::string ExpressionWriter::call(const graph::Node& node) {
    const std::string name = function(node);
    std::vector<std::string> arguments;
    for (NodeId argument : node.args()) arguments.push_back(spelling(argument));
    const bool is_sign = name.find_first_not_of("+-*/") == std::string_view::npos;
    if (is_sign && arguments.size() == 1) return fmt::format("{}{}", name, arguments[0]);
    if (is_sign) return fmt::format("{} {} {}", arguments[0], name, arguments[1]);
    return fmt::format("{}({})", name, fmt::join(arguments, ", "));
}

std::vector<NodeId> ExpressionWriter::open(std::span<const NodeId> roots) const {
    const std::vector<NodeId> all = reachable(graph_, roots);
    std::set<NodeId> wanted(roots.begin(), roots.end());
    std::vector<NodeId> list;
    for (auto it = all.rbegin(); it != all.rend(); ++it) {
        const std::span<const NodeId> arguments = graph_[*it].args();
        if (!wanted.contains(*it) || !depends_[index(*it)] || written_.contains(*it)) continue;
        wanted.insert(arguments.begin(), arguments.end());
        if (!arguments.empty()) list.push_back(*it);
    }
    std::ranges::reverse(list);
    return list;
}

std::string ExpressionWriter::statements(std::span<const NodeId> roots, std::string_view indent) {
    const std::vector<NodeId> list = open(roots);
    std::map<NodeId, WavePair> waves;  // by argument
    for (NodeId id : list) {
        const graph::Node& node = graph_[id];
        if (node.op == Op::sin) waves[node.arguments[0]].sine = id;
        if (node.op == Op::cos) waves[node.arguments[0]].cosine = id;
    }
    std::string text;
    for (NodeId id : list) {
        if (written_.contains(id)) continue;  // with its partner
        const graph::Node& node = graph_[id];
        const std::string right = call(node);
        const std::string name = fmt::format("n{}", count_++);
        const bool is_wave = node.op == Op::sin || node.op == Op::cos;
        const WavePair pair = is_wave ? waves.at(node.arguments[0]) : WavePair{};
        if (pair.sine && pair.cosine) {
            text += fmt::format("{}real2 {} = zs_sincos({});\n", indent, name,
                                spelling(node.arguments[0]));
            written_[*pair.sine] = name + ".x";
            written_[*pair.cosine] = name + ".y";
        } else {
            text += fmt::format("{}real {} = {};\n", indent, name, right);
            written_[id] = name;
        }
    }
    return text;
}

}  // namespace shader
