// SPDX-License-Identifier: MIT
#include "shader/iteration_glsl.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
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

/// Parts of the escape that `others` use as well, of two operations or more: worth carrying.
std::vector<NodeId> shared_parts(const graph::Graph& graph, NodeId escape,
                                 const std::vector<NodeId>& others,
                                 const std::vector<bool>& on_state) {
    const std::vector<NodeId> other_nodes = reachable(graph, others);
    std::map<NodeId, int> operations;  // of what is in both
    for (const NodeId id : reachable(graph, std::array{escape})) {
        if (!on_state[index(id)] || !std::ranges::binary_search(other_nodes, id)) continue;
        int& count = operations[id];
        if (!graph[id].args().empty()) count = 1;
        for (const NodeId argument : graph[id].args()) {
            const auto known = operations.find(argument);
            if (known != operations.end()) count += known->second;
        }
    }
    std::set<NodeId> used(others.begin(), others.end());
    for (const NodeId id : other_nodes) {
        if (operations.contains(id)) continue;
        used.insert(graph[id].args().begin(), graph[id].args().end());
    }
    std::vector<NodeId> list;
    for (const auto& [id, count] : operations) {
        if (count >= 2 && used.contains(id)) list.push_back(id);
    }
    return list;
}

/// Writes the loop up to its end, and which of the state it has carried there. `inside` is then
/// whether the last state has not escaped; false where nothing escapes. The test stands at the end
/// of the turn: where lanes share their code, no turn is made for lanes that are all done.
class Loop {
public:
    Loop(const graph::Graph& graph, const field::Iteration& iteration, ExpressionWriter& writer,
         FieldValues& values)
        : graph_(graph),
          iteration_(iteration),
          writer_(writer),
          values_(values),
          on_state_(depends_on(graph, iteration.state)) {}

    std::string write(std::span<const NodeId> answers) {
        const std::vector<bool> needed = needed_state(graph_, iteration_, answers);
        for (std::size_t i = 0; i < needed.size(); ++i) {
            if (!needed[i]) continue;
            state_.push_back(i);
            steps_.push_back(iteration_.step[i]);
        }
        if (iteration_.escape) {
            std::vector<NodeId> others = steps_;
            others.insert(others.end(), answers.begin(), answers.end());
            carried_ = shared_parts(graph_, *iteration_.escape, others, on_state_);
        }
        std::string text = before();
        text += turns();
        return text;
    }

private:
    /// What is the same at all turns, and the state before the first.
    std::string before() {
        std::vector<NodeId> inner = steps_;
        if (iteration_.escape) inner.push_back(*iteration_.escape);
        std::vector<NodeId> outer = loop_invariants(graph_, inner, on_state_);
        for (const std::size_t i : state_) outer.push_back(iteration_.start[i]);
        std::string text = writer_.statements(outer, "    ");
        for (const std::size_t i : state_) {
            writer_.name(iteration_.state[i], fmt::format("s{}", i));
            text += fmt::format("    real s{} = {};\n", i, writer_.spelling(iteration_.start[i]));
        }
        return text;
    }

    /// Of the present state: whether it has escaped, and what is carried besides it.
    std::string test(const char* indent, const char* declared) {
        if (!iteration_.escape) return {};
        const ExpressionWriter::Scope scope = writer_.scope();
        std::vector<NodeId> roots = carried_;
        roots.push_back(*iteration_.escape);
        std::string text = writer_.statements(roots, indent);
        for (std::size_t i = 0; i < carried_.size(); ++i) {
            text +=
                fmt::format("{}{}c{} = {};\n", indent, declared, i, writer_.spelling(carried_[i]));
        }
        text +=
            fmt::format("{}inside = !({} > 0.0);\n", indent, writer_.spelling(*iteration_.escape));
        writer_.return_to(scope);
        return text;
    }

    /// One more turn of the state, where `goes_on` is empty or holds, and what is carried of it.
    std::string turn(const char* indent, std::string_view goes_on) {
        const ExpressionWriter::Scope outside = writer_.scope();
        for (std::size_t i = 0; i < carried_.size(); ++i) {
            writer_.know(carried_[i], fmt::format("c{}", i));
        }
        std::string text = writer_.statements(steps_, indent);
        for (const std::size_t i : state_) {
            text += fmt::format("{}real next{} = {};\n", indent, i,
                                writer_.spelling(iteration_.step[i]));
        }
        for (const std::size_t i : state_) {
            text += goes_on.empty()
                        ? fmt::format("{0}s{1} = next{1};\n", indent, i)
                        : fmt::format("{0}s{1} = {2} ? next{1} : s{1};\n", indent, i, goes_on);
        }
        writer_.return_to(outside);
        return text + test(indent, "");
    }

    /// Whether two turns are made to a branch: where lanes share their code, a branch costs as much
    /// as a small turn. The second changes nothing where the first was the last.
    bool is_small() const {
        std::vector<NodeId> roots = steps_;
        if (!iteration_.escape) return false;
        roots.push_back(*iteration_.escape);
        constexpr std::ptrdiff_t most_operations = 32;
        return std::ranges::count_if(reachable(graph_, roots), [&](NodeId id) {
                   return on_state_[index(id)] && !graph_[id].args().empty();
               }) <= most_operations;
    }

    std::string turns() {
        std::string text =
            fmt::format("    int left = int({} + 0.5);\n", values_.expression(iteration_.limit));
        text += iteration_.escape ? test("    ", "real ") : "    inside = false;\n";
        text += fmt::format("    if (left > 0{}) {{\n        while (true) {{\n",
                            iteration_.escape ? " && inside" : "");
        const char* indent = "            ";
        text += turn(indent, "");
        if (is_small()) {
            text += fmt::format("{0}bool again = --left > 0 && inside;\n{0}{{\n", indent);
            text += turn("                ", "again") + fmt::format("{}}}\n", indent);
        }
        text += fmt::format("{}if (--left <= 0{}) break;\n        }}\n    }}\n", indent,
                            iteration_.escape ? " || !inside" : "");
        for (std::size_t i = 0; i < carried_.size(); ++i) {
            writer_.know(carried_[i], fmt::format("c{}", i));
        }
        return text;
    }

    const graph::Graph& graph_;
    const field::Iteration& iteration_;
    ExpressionWriter& writer_;
    FieldValues& values_;
    std::vector<bool> on_state_;
    std::vector<std::size_t> state_{};  ///< that is carried
    std::vector<NodeId> steps_{};       ///< its steps
    std::vector<NodeId> carried_{};     ///< and what else is
};

}  // namespace

std::string iteration_body(const graph::Graph& graph, const field::Iteration& iteration,
                           ExpressionWriter& writer, FieldValues& values) {
    std::vector<NodeId> answers{iteration.distance};
    if (iteration.evenness) answers.push_back(*iteration.evenness);
    std::string text = Loop(graph, iteration, writer, values).write(answers);
    text += writer.statements(answers, "    ");
    if (iteration.evenness && !graph.is_constant(*iteration.evenness, 1)) {
        text += fmt::format("    zs_evenness = min(zs_evenness, {});\n",
                            writer.spelling(*iteration.evenness));
    }
    return text + fmt::format("    return {};\n", writer.spelling(iteration.distance));
}

std::string iteration_gradient(const graph::Graph& graph, const field::Iteration& iteration,
                               std::span<const NodeId> gradient, ExpressionWriter& writer,
                               FieldValues& values) {
    std::string text = "    bool inside;\n";
    text += Loop(graph, iteration, writer, values).write(gradient);
    text += writer.statements(gradient, "    ");
    return text + fmt::format("    return real3({}, {}, {});\n", writer.spelling(gradient[0]),
                              writer.spelling(gradient[1]), writer.spelling(gradient[2]));
}

std::string iteration_colour(const graph::Graph& graph, const field::Iteration& iteration,
                             ExpressionWriter& writer, FieldValues& values) {
    std::string text = "    bool inside;\n";
    text += Loop(graph, iteration, writer, values).write(*iteration.colour);
    text += writer.statements(*iteration.colour, "    ");
    return text;
}

}  // namespace shader
