// SPDX-License-Identifier: MIT
#include "shader/iteration_glsl.h"

#include <algorithm>

#include <fmt/format.h>

namespace shader {
namespace {

using graph::NodeId;
using graph::Op;

/// For each node whether it depends on one of these variables.
std::vector<bool> depends_on(const graph::Graph& graph,
                             const std::vector<graph::VariableId>& variables) {
    std::vector<bool> depends(graph.size(), false);
    for (std::size_t i = 0; i < graph.size(); ++i) {
        const graph::Node& node = graph[static_cast<NodeId>(i)];
        depends[i] =
            (node.op == Op::variable &&
             std::ranges::count(variables, static_cast<graph::VariableId>(node.symbol)) > 0) ||
            std::ranges::any_of(node.args(), [&](NodeId a) { return depends[index(a)]; });
    }
    return depends;
}

/// What the roots need and can be computed before the loop: the largest parts without state.
std::vector<NodeId> loop_invariants(const graph::Graph& graph, const std::vector<NodeId>& roots,
                                    const std::vector<bool>& on_state) {
    std::vector<NodeId> list;
    for (NodeId id : reachable(graph, roots)) {
        if (!on_state[index(id)]) list.push_back(id);
    }
    return list;
}

}  // namespace

std::string iteration_body(const graph::Graph& graph, const field::Iteration& iteration,
                           ExpressionWriter& writer, FieldValues& values) {
    const std::size_t size = iteration.state.size();
    std::vector<NodeId> inner = iteration.step;
    if (iteration.escape) inner.push_back(*iteration.escape);
    std::vector<NodeId> outer = loop_invariants(graph, inner, depends_on(graph, iteration.state));
    outer.insert(outer.end(), iteration.start.begin(), iteration.start.end());

    std::string text = writer.statements(outer, "    ");
    for (std::size_t i = 0; i < size; ++i) {
        writer.name(iteration.state[i], fmt::format("s{}", i));
        text += fmt::format("    real s{} = {};\n", i, writer.spelling(iteration.start[i]));
    }
    const ExpressionWriter::Scope before = writer.scope();
    text += fmt::format(
        "    inside = {};\n"
        "    int limit = int({} + 0.5);\n"
        "    for (int i = 0; i < limit; ++i) {{\n",
        iteration.escape.has_value(), values.expression(iteration.limit));
    text += writer.statements(inner, "        ");
    if (iteration.escape) {
        text += fmt::format(
            "        if ({} > 0.0) {{\n            inside = false;\n            break;\n        "
            "}}\n",
            writer.spelling(*iteration.escape));
    }
    for (std::size_t i = 0; i < size; ++i) {
        text += fmt::format("        real next{} = {};\n", i, writer.spelling(iteration.step[i]));
    }
    for (std::size_t i = 0; i < size; ++i) text += fmt::format("        s{0} = next{0};\n", i);
    text += "    }\n";
    writer.return_to(before);

    std::vector<NodeId> after{iteration.distance};
    if (iteration.escape) after.push_back(*iteration.escape);
    text += writer.statements(after, "    ");
    if (iteration.escape) {
        text +=
            fmt::format("    if ({} > 0.0) inside = false;\n", writer.spelling(*iteration.escape));
    }
    return text + fmt::format("    return {};\n", writer.spelling(iteration.distance));
}

}  // namespace shader
