// SPDX-License-Identifier: MIT
#include "shader/field_glsl.h"

#include <utility>

#include <fmt/format.h>

#include "shader/field_code.h"

namespace shader {
namespace {

/// Whether all leaves are iterations of the point itself or distances, in one piece of space.
bool answers_balls(const FieldCode& code) {
    bool iterates = false;
    for (std::size_t i = 0; i < code.plan.objects.size(); ++i) {
        const Object& object = code.plan.objects[i];
        const field::Iteration* iteration = code.iteration(i);
        const bool ball = iteration ? !iteration->image : code.is_distance(i);
        if (!ball || object.blend || !object.cells.empty()) return false;
        iterates = iterates || iteration;
    }
    return iterates;
}

/// Whether every answer has a derivative along the ray.
bool has_rates(const FieldCode& code) {
    for (std::size_t i = 0; i < code.plan.objects.size(); ++i) {
        if (!code.formula(i) || code.is_distance(i) || code.plan.objects[i].blend) return false;
    }
    return true;
}

bool is_regular(const FieldCode& code) {
    return has_rates(code) && !code.edges && !code.breaks && !code.clips;
}

/// Whether it is known of all iterations how far the surface is mostly beyond the estimate.
bool knows_evenness(const FieldCode& code) {
    for (std::size_t i = 0; i < code.plan.objects.size(); ++i) {
        const field::Iteration* iteration = code.iteration(i);
        if (iteration && !iteration->evenness) return false;
    }
    return answers_balls(code);
}

/// How many times as long as the ball's radius a shadow ray may step: by estimates longer, since
/// the surface is mostly twice as far, and where it is not, a shadow misses what is thin.
/// Heuristic.
int longer_shadow_steps(const FieldCode& code) { return answers_balls(code) ? 2 : 1; }

std::string facts(const FieldCode& code) {
    return fmt::format(
        "const bool zs_has_edges = {};\nconst bool zs_has_rates = {};\n"
        "const bool zs_knows_evenness = {};\nconst real zs_longer_steps = {}.0;\n"
        "const int zs_objects = {};\n",
        code.edges, has_rates(code), knows_evenness(code), longer_shadow_steps(code),
        code.plan.objects.size());
}

}  // namespace

FieldGlsl field_glsl(field::Field field, bool count_evaluations, const Demands& demands,
                     std::vector<field::FieldId> bricks, Precision precision) {
    FieldCode code(std::move(field), demands, precision);
    if (demands.bricks) code.out.bricks = std::move(bricks);
    if (!code.out.bricks.empty()) code.needs("brick/brick.glsl");
    write_families(code);
    write_leaves(code);
    write_cells(code);
    write_blends(code);
    write_tree(code, count_evaluations);
    if (code.demands.intervals) write_enclosures(code, count_evaluations);
    write_gradients(code);
    if (is_regular(code)) write_rounding(code);
    write_colours(code);
    code.out.facts = facts(code);
    code.out.has_edges = code.edges;
    code.out.answers_balls = answers_balls(code);
    code.out.is_regular = is_regular(code);
    code.out.values = code.values.list();
    code.out.expressions = eval::make_tape(code.field.graph, code.values.expressions());
    return std::move(code.out);
}

}  // namespace shader
