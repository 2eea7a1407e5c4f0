// SPDX-License-Identifier: MIT
#include "passes/pipeline.h"

#include "passes/expand_powers.h"
#include "passes/fold_constants.h"
#include "passes/recognise_hypot.h"
#include "passes/simplify.h"

namespace passes {
namespace {

constexpr Pass order[] = {
    {"fold constants", fold_constants},
    {"expand powers", expand_powers},
    {"simplify", simplify},
    {"recognise lengths", recognise_hypot},
    {"fold constants again", fold_constants},
};

}  // namespace

std::span<const Pass> pipeline() { return order; }

void run(field::Field& field) {
    for (const Pass& pass : order) rewrite(field, pass.rule);
}

std::vector<graph::NodeId> run(graph::Graph& graph, std::span<const graph::NodeId> roots) {
    std::vector<graph::NodeId> result(roots.begin(), roots.end());
    for (const Pass& pass : order) result = rewrite(graph, result, pass.rule);
    return result;
}

}  // namespace passes
