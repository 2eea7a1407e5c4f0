// SPDX-License-Identifier: MIT
#include "analysis/dependence.h"

#include <algorithm>

#include "field/parts.h"

namespace analysis {
namespace {

using graph::NodeId;

void collect(const field::Field& field, field::FieldId id, std::vector<NodeId>& roots) {
    const std::vector<NodeId> own = field::expressions(field::shape(field, id));
    roots.insert(roots.end(), own.begin(), own.end());
    for (const field::FieldId child : field::children(field[id])) collect(field, child, roots);
}

}  // namespace

Dependence dependence(const graph::Graph& graph, std::span<const NodeId> roots) {
    Dependence result;
    for (const NodeId id : reachable(graph, roots)) {
        const graph::Node& node = graph[id];
        if (node.op == graph::Op::variable && node.symbol < result.point.size()) {
            result.point[node.symbol] = true;
        }
        if (node.op != graph::Op::parameter) continue;
        const auto parameter = static_cast<graph::ParameterId>(node.symbol);
        if (parameter == graph::parameter_t) {
            result.time = true;
        } else {
            result.parameters.push_back(parameter);
        }
    }
    std::ranges::sort(result.parameters);
    return result;
}

Dependence dependence(const field::Field& field, field::FieldId id) {
    std::vector<NodeId> roots;
    collect(field, id, roots);
    return dependence(field.graph, roots);
}

}  // namespace analysis
