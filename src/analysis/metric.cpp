// SPDX-License-Identifier: MIT
#include "analysis/metric.h"

#include <algorithm>
#include <variant>
#include <vector>

namespace analysis {
namespace {

struct Visitor {
    const field::Field& field;
    field::FieldId id;
    const std::function<double(field::FieldId)>& lipschitz;

    Metric of(field::FieldId child) const { return metric(field, child, lipschitz); }
    Metric joined(const std::vector<field::FieldId>& nodes) const {
        Metric result = Metric::bound;
        for (const field::FieldId it : nodes) result = std::max(result, of(it));
        return result;
    }

    Metric operator()(const field::Formula& leaf) const {
        if (leaf.exact) return Metric::exact;
        if (leaf.metric == field::Metric::distance) return Metric::bound;
        return lipschitz(id) <= 1 ? Metric::bound : Metric::none;
    }
    Metric operator()(const field::Iteration& leaf) const {
        return leaf.image ? Metric::none : Metric::estimate;
    }
    Metric operator()(const field::Complement& node) const { return of(node.a); }
    Metric operator()(const field::Union& node) const { return joined({node.a, node.b}); }
    Metric operator()(const field::Intersection& node) const { return joined({node.a, node.b}); }
    Metric operator()(const field::Choice& node) const { return std::max(of(node.a), of(node.b)); }
    Metric operator()(const field::Blend& node) const {
        return node.displacement ? Metric::none : joined(node.operands);
    }
    // The copy in a neighbouring cell may be nearer.
    Metric operator()(const field::Cells&) const { return Metric::none; }
};

}  // namespace

Metric metric(const field::Field& field, field::FieldId id,
              const std::function<double(field::FieldId)>& lipschitz) {
    return std::visit(Visitor{field, id, lipschitz}, field[id]);
}

}  // namespace analysis
