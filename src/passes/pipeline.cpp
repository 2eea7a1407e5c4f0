// SPDX-License-Identifier: MIT
#include "passes/pipeline.h"

#include "passes/divide_by_constants.h"
#include "passes/expand_powers.h"
#include "passes/fold_constants.h"
#include "passes/gather_factors.h"
#include "passes/gather_terms.h"
#include "passes/horner.h"
#include "passes/operation_count.h"
#include "passes/order_operands.h"
#include "passes/recognise_hypot.h"
#include "passes/simplify.h"

namespace passes {
namespace {

using graph::Graph;
using graph::NodeId;

constexpr Pass order[] = {
    {"fold constants", everywhere<fold_constants>},
    {"simplify", everywhere<simplify>},
    {"divide by constants", divide_by_constants},
    {"gather factors", gather_factors},
    {"gather terms", gather_terms},
    {"expand powers", expand_powers},
    {"simplify again", everywhere<simplify>},
    {"recognise lengths", everywhere<recognise_hypot>},
    {"order operands", everywhere<order_operands>},
    {"fold constants again", everywhere<fold_constants>},
    {"Horner's form", horner, Stage::evaluation},
    {"share powers again", expand_powers, Stage::evaluation},
    {"order operands again", everywhere<order_operands>, Stage::evaluation},
};

/// Expressions on their way through the passes.
class Expressions {
public:
    Expressions(Graph& graph, std::span<const NodeId> roots)
        : graph_(graph), roots_(roots.begin(), roots.end()), cost_(cost(roots_)) {}

    void pass(const Pass& pass) {
        std::vector<NodeId> rewritten = pass.transformation(graph_, roots_);
        if (rewritten == roots_) return;
        const std::size_t new_cost = cost(rewritten);
        if (new_cost > cost_) return;
        roots_ = std::move(rewritten);
        cost_ = new_cost;
    }
    const std::vector<NodeId>& roots() const { return roots_; }

private:
    std::size_t cost(std::span<const NodeId> roots) const {
        return count_operations(graph_, roots).multiplied_out;
    }

    Graph& graph_;
    std::vector<NodeId> roots_;
    std::size_t cost_;
};

}  // namespace

std::span<const Pass> pipeline() { return order; }

void run(field::Field& field, Stage stage, const Observer& observer) {
    const std::vector<NodeId*> places = all_expressions(field);
    std::vector<NodeId> roots;
    for (const NodeId* place : places) roots.push_back(*place);
    Expressions expressions(field.graph, roots);
    for (const Pass& pass : order) {
        if (pass.stage != stage) continue;
        expressions.pass(pass);
        for (std::size_t i = 0; i < places.size(); ++i) *places[i] = expressions.roots()[i];
        if (observer) observer(pass, field);
    }
}

std::vector<NodeId> run(Graph& graph, std::span<const NodeId> roots, Stage stage) {
    Expressions expressions(graph, roots);
    for (const Pass& pass : order) {
        if (pass.stage == stage) expressions.pass(pass);
    }
    return expressions.roots();
}

}  // namespace passes
