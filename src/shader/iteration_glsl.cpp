// SPDX-License-Identifier: MIT
#include "shader/iteration_glsl.h"

#include <algorithm>
#include <array>
#include <span>

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

/// Writes the loop up to its end, and which of the state it has carried there. `inside` is then
/// whether no turn but perhaps the last has escaped.
class Loop {
public:
    Loop(const graph::Graph& graph, const field::Iteration& iteration, ExpressionWriter& writer,
         FieldValues& values)
        : graph_(graph), iteration_(iteration), writer_(writer), values_(values) {}

    std::string write(std::span<const NodeId> answers) {
        const std::vector<bool> needed = needed_state(graph_, iteration_, answers);
        std::vector<std::size_t> state;
        for (std::size_t i = 0; i < needed.size(); ++i) {
            if (needed[i]) state.push_back(i);
        }
        std::vector<NodeId> inner;
        for (const std::size_t i : state) inner.push_back(iteration_.step[i]);
        if (iteration_.escape) inner.push_back(*iteration_.escape);
        std::string text = before(state, inner);
        text += turns(state, inner);
        return text;
    }

private:
    std::string before(std::span<const std::size_t> state, const std::vector<NodeId>& inner) {
        std::vector<NodeId> outer =
            loop_invariants(graph_, inner, depends_on(graph_, iteration_.state));
        for (const std::size_t i : state) outer.push_back(iteration_.start[i]);
        std::string text = writer_.statements(outer, "    ");
        for (const std::size_t i : state) {
            writer_.name(iteration_.state[i], fmt::format("s{}", i));
            text += fmt::format("    real s{} = {};\n", i, writer_.spelling(iteration_.start[i]));
        }
        return text;
    }

    std::string turns(std::span<const std::size_t> state, const std::vector<NodeId>& inner) {
        const ExpressionWriter::Scope scope = writer_.scope();
        std::string text = fmt::format(
            "    inside = {};\n"
            "    int limit = int({} + 0.5);\n"
            "    for (int i = 0; i < limit; ++i) {{\n",
            iteration_.escape.has_value(), values_.expression(iteration_.limit));
        text += writer_.statements(inner, "        ");
        if (iteration_.escape) {
            text += fmt::format(
                "        if ({} > 0.0) {{\n            inside = false;\n            break;\n       "
                " "
                "}}\n",
                writer_.spelling(*iteration_.escape));
        }
        for (const std::size_t i : state) {
            text +=
                fmt::format("        real next{} = {};\n", i, writer_.spelling(iteration_.step[i]));
        }
        for (const std::size_t i : state) text += fmt::format("        s{0} = next{0};\n", i);
        writer_.return_to(scope);
        return text + "    }\n";
    }

    const graph::Graph& graph_;
    const field::Iteration& iteration_;
    ExpressionWriter& writer_;
    FieldValues& values_;
};

}  // namespace

std::string iteration_body(const graph::Graph& graph, const field::Iteration& iteration,
                           ExpressionWriter& writer, FieldValues& values) {
    std::string text = Loop(graph, iteration, writer, values).write(std::array{iteration.distance});
    std::vector<NodeId> after{iteration.distance};
    if (iteration.escape) after.push_back(*iteration.escape);
    text += writer.statements(after, "    ");
    if (iteration.escape) {
        text +=
            fmt::format("    if ({} > 0.0) inside = false;\n", writer.spelling(*iteration.escape));
    }
    return text + fmt::format("    return {};\n", writer.spelling(iteration.distance));
}

std::string iteration_colour(const graph::Graph& graph, const field::Iteration& iteration,
                             ExpressionWriter& writer, FieldValues& values) {
    std::string text = "    bool inside;\n";
    text += Loop(graph, iteration, writer, values).write(*iteration.colour);
    text += writer.statements(*iteration.colour, "    ");
    return text;
}

}  // namespace shader
