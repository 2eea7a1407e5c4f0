// SPDX-License-Identifier: MIT
#include "shader/field_plan.h"

#include <algorithm>

#include "field/parts.h"

namespace shader {
namespace {

using field::FieldId;

struct Planner {
    const field::Field& field;
    const std::map<FieldId, Family>& families;
    FieldPlan plan{};
    std::vector<FieldId> cells{};  ///< above the node that is looked at
    std::optional<std::size_t> blend{};

    void visit(FieldId id) {
        const field::Node& node = field[id];
        const std::vector<FieldId> below = children(node);
        if (below.empty()) return add_object(id);
        if (families.contains(id)) return add_family(id);
        const bool is_blend = std::holds_alternative<field::Blend>(node);
        if (is_blend && std::ranges::count(plan.mixes, id) == 0) plan.mixes.push_back(id);
        const bool outermost = is_blend && !blend;
        if (outermost) {
            blend = plan.blends.size();
            plan.blends.push_back({id, cells, plan.objects.size()});
        }
        const bool is_cells = std::holds_alternative<field::Cells>(node);
        if (is_cells) {
            if (std::ranges::count(plan.cells, id) == 0) plan.cells.push_back(id);
            cells.push_back(id);
        }
        for (const FieldId child : below) visit(child);
        if (is_cells) cells.pop_back();
        if (outermost) blend.reset();
    }

    void add_family(FieldId id) {
        plan.families.push_back({id, cells, plan.objects.size()});
        for (const FieldId member : leaves(field, id)) {
            plan.objects.push_back({member, cells, {}, true});
        }
    }

    void add_object(FieldId id) {
        plan.objects.push_back({id, cells, blend});
        const auto* iteration = std::get_if<field::Iteration>(&field[id]);
        if (!blend || !iteration) return;
        plan.blends[*blend].iterates = true;
        if (iteration->escape) plan.blends[*blend].escapes = true;
    }
};

}  // namespace

std::size_t FieldPlan::cells_number(FieldId id) const {
    return static_cast<std::size_t>(std::ranges::find(cells, id) - cells.begin());
}

FieldPlan field_plan(const field::Field& field, const std::map<FieldId, Family>& families) {
    Planner planner{field, families};
    planner.visit(field.root);
    return std::move(planner.plan);
}

}  // namespace shader
