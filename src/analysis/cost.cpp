// SPDX-License-Identifier: MIT
#include "analysis/cost.h"

#include <span>
#include <vector>

#include "field/parts.h"

namespace analysis {
namespace {

using graph::NodeId;

struct Counter {
    const field::Field& field;
    std::vector<bool> dependent;
    Cost cost{};
    std::vector<NodeId> all{};  ///< all expressions so far

    std::size_t operations(std::span<const NodeId> roots, bool of_dependent) const {
        std::size_t count = 0;
        for (const NodeId id : reachable(field.graph, roots)) {
            count += !field.graph[id].args().empty() && dependent[index(id)] == of_dependent;
        }
        return count;
    }

    void add(const field::Node& node) {
        const std::vector<NodeId> own = field::expressions(node);
        all.insert(all.end(), own.begin(), own.end());
        if (const auto* iteration = std::get_if<field::Iteration>(&node)) {
            cost.point += operations(iteration->start, true);
            cost.point += operations(std::span(&iteration->distance, 1), true);
            std::vector<NodeId> turn = iteration->step;
            if (iteration->escape) turn.push_back(*iteration->escape);
            cost.turn += operations(turn, true);
        } else {
            cost.point += operations(own, true);
        }
    }

    void add(field::FieldId id) {
        add(field::shape(field, id));
        const std::vector<field::FieldId> below = field::children(field[id]);
        if (!below.empty()) ++cost.point;
        for (const field::FieldId child : below) add(child);
    }
};

}  // namespace

Cost cost(const field::Field& field, field::FieldId id) {
    Counter counter{field, depends_on_variables(field.graph)};
    counter.add(id);
    counter.cost.hoisted = counter.operations(counter.all, false);
    return counter.cost;
}

}  // namespace analysis
