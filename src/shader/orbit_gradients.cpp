// SPDX-License-Identifier: MIT
// Iterations whose normals are by derivatives that they carry.
#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "passes/dual_numbers.h"
#include "passes/operation_count.h"
#include "passes/pipeline.h"
#include "shader/field_code.h"

namespace shader {

namespace {

/// At a start, at a turn and at the end: what these answers of an iteration take.
std::size_t operations(const graph::Graph& graph, const field::Iteration& iteration,
                       std::span<const graph::NodeId> answers) {
    const std::vector<bool> needed = needed_state(graph, iteration, answers);
    std::size_t count = passes::count_operations(graph, answers).multiplied_out;
    for (const auto* expressions : {&iteration.start, &iteration.step}) {
        std::vector<graph::NodeId> roots;
        for (std::size_t i = 0; i < needed.size(); ++i) {
            if (needed[i]) roots.push_back((*expressions)[i]);
        }
        count += passes::count_operations(graph, roots).multiplied_out;
    }
    return count;
}

}  // namespace

/// Iterations that always make the same turns carry their gradient where that takes less than four
/// differences. Sets that orbits escape from have details below a pixel, over which the normal is
/// meant to be a mean.
void FieldCode::differentiate_orbits() {
    constexpr std::size_t differences = 4;
    for (std::size_t i = 0; i < plan.objects.size(); ++i) {
        const Object& object = plan.objects[i];
        if (!iteration(i) || iteration(i)->escape || object.blend) continue;
        if (orbit_gradients.contains(object.id)) continue;
        const field::Iteration& plain = *iteration(i);
        field::Iteration dual = plain;
        const auto slopes =
            passes::add_derivatives(field.graph, dual, std::array{plain.distance})[0];
        std::vector<graph::NodeId> roots = dual.start;
        roots.insert(roots.end(), dual.step.begin(), dual.step.end());
        roots.insert(roots.end(), slopes.begin(), slopes.end());
        roots = passes::run(field.graph, roots);
        const std::size_t count = dual.state.size();
        std::copy_n(roots.begin(), count, dual.start.begin());
        std::copy_n(roots.begin() + static_cast<std::ptrdiff_t>(count), count, dual.step.begin());
        const Gradient gradient{roots[2 * count], roots[2 * count + 1], roots[2 * count + 2]};
        if (operations(field.graph, dual, gradient) >=
            differences * operations(field.graph, plain, std::array{plain.distance})) {
            continue;
        }
        orbit_gradients[object.id] = gradient;
        field.nodes[index(object.id)] = std::move(dual);
    }
}

}  // namespace shader
