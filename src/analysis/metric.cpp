// SPDX-License-Identifier: MIT
#include "analysis/metric.h"

#include <algorithm>
#include <variant>

namespace analysis {
namespace {

struct Visitor {
    const field::Field& field;
    field::FieldId id;
    const std::function<double(field::FieldId)>& lipschitz;

    Metric of(field::FieldId child) const { return metric(field, child, lipschitz); }
    Metric joined(field::FieldId a, field::FieldId b) const {
        return std::max({Metric::bound, of(a), of(b)});
    }

    Metric operator()(const field::Formula& leaf) const {
        if (leaf.exact) return Metric::exact;
        if (leaf.metric == field::Metric::distance) return Metric::bound;
        return lipschitz(id) <= 1 ? Metric::bound : Metric::none;
    }
    Metric operator()(const field::Iteration&) const { return Metric::estimate; }
    Metric operator()(const field::Complement& node) const { return of(node.a); }
    Metric operator()(const field::Union& node) const { return joined(node.a, node.b); }
    Metric operator()(const field::Intersection& node) const { return joined(node.a, node.b); }
    Metric operator()(const field::SmoothUnion& node) const { return joined(node.a, node.b); }
};

}  // namespace

Metric metric(const field::Field& field, field::FieldId id,
              const std::function<double(field::FieldId)>& lipschitz) {
    return std::visit(Visitor{field, id, lipschitz}, field[id]);
}

}  // namespace analysis
