// SPDX-License-Identifier: MIT
#include "field/blends.h"

#include <functional>
#include <utility>

#include "field/compose.h"
#include "graph/build.h"

namespace field {
namespace {

using graph::Expr;
using graph::NodeId;

/// Narrower than any pixel, and still no denormal number in single precision.
constexpr double least_width = 1e-30;

/// The value of the whole from those of its parts; changes by no more than that part which changes
/// most.
using Value = std::function<Expr(const std::vector<Expr>&)>;

FieldId blend(Field& field, const std::vector<FieldId>& operands, const Value& value) {
    std::vector<Formula> formulas;
    for (const FieldId id : operands) {
        const auto formula = composed(field, id);
        if (!formula) break;
        formulas.push_back(*formula);
    }
    std::vector<Expr> parts;
    std::optional<Formula> whole;
    if (formulas.size() == operands.size()) whole = joined(field, formulas);
    if (whole) {
        for (const Formula& it : formulas) parts.emplace_back(field.graph, it.value);
        whole->value = value(parts).id;
        if (const auto outlines = take_minima(field, formulas, *whole)) {
            for (std::size_t i = 0; i < parts.size(); ++i) parts[i].id = (*outlines)[i];
            whole->outline = value(parts).id;
        }
        return field.add(std::move(*whole));
    }
    Blend result{.operands = operands, .values = {}};
    for (std::size_t i = 0; i < operands.size(); ++i) {
        result.values.push_back(field.graph.new_variable("f" + std::to_string(i)));
        parts.emplace_back(field.graph, field.graph.variable(result.values[i]));
    }
    result.value = value(parts).id;
    return field.add(std::move(result));
}

/// A number that a slider may bring down to 0, safe to divide by.
Expr positive(Field& field, NodeId id) {
    const Expr number(field.graph, id);
    return field.graph.is_constant(id) ? number : max(number, least_width);
}

/// Has a gradient that is a convex combination of both gradients.
Expr polynomial_minimum(Expr a, Expr b, Expr k) {
    const Expr overlap = max(k - abs(a - b), 0.0) / k;
    return min(a, b) - overlap * overlap * k * 0.25;
}

/// The same.
Expr exponential_minimum(Expr a, Expr b, Expr k) {
    return min(a, b) - log(1.0 + exp(-(k * abs(a - b)))) / k;
}

/// Weighs both gradients by (f / a)^(p + 1) and (f / b)^(p + 1), whose sum is at most 1 since
/// (f / a)^p + (f / b)^p = 1.
Expr power_minimum(Expr a, Expr b, Expr p) {
    const Expr least = min(a, b), most = max(a, b);
    const Expr part = ratio(max(least, 0.0), max(most, 0.0));
    return least * pow(1.0 + pow(part, p), -1.0 / p);
}

}  // namespace

FieldId smooth_union(Field& field, FieldId a, FieldId b, NodeId k) {
    const Expr width = positive(field, k);
    return blend(field, {a, b},
                 [&](const std::vector<Expr>& f) { return polynomial_minimum(f[0], f[1], width); });
}

FieldId smooth_union(Field& field, const std::vector<FieldId>& operands, NodeId k) {
    const Expr width = positive(field, k);
    const FieldId id = blend(field, operands, [&](const std::vector<Expr>& f) {
        Expr least = f[0];
        for (std::size_t i = 1; i < f.size(); ++i) least = polynomial_minimum(least, f[i], width);
        return least;
    });
    auto* whole = std::get_if<Formula>(&field.nodes[index(id)]);
    const bool of_distances = whole && whole->metric == Metric::distance && whole->minima.empty();
    if (!of_distances || operands.size() < many) return id;
    Minimum minimum{{}, width.id, field.graph.new_variable("minimum")};
    for (const FieldId it : operands) minimum.operands.push_back(composed(field, it)->value);
    // Composing may have added nodes.
    whole = &std::get<Formula>(field.nodes[index(id)]);
    whole->outline = field.graph.variable(minimum.variable);
    whole->minima = {std::move(minimum)};
    return id;
}

FieldId smooth_union_exp(Field& field, FieldId a, FieldId b, NodeId k) {
    const Expr sharpness = positive(field, k);
    return blend(field, {a, b}, [&](const std::vector<Expr>& f) {
        return exponential_minimum(f[0], f[1], sharpness);
    });
}

FieldId smooth_union_power(Field& field, FieldId a, FieldId b, NodeId p) {
    const Expr exponent = positive(field, p);
    return blend(field, {a, b},
                 [&](const std::vector<Expr>& f) { return power_minimum(f[0], f[1], exponent); });
}

FieldId smooth_intersection(Field& field, FieldId a, FieldId b, NodeId k) {
    const Expr width = positive(field, k);
    return blend(field, {a, b}, [&](const std::vector<Expr>& f) {
        return -polynomial_minimum(-f[0], -f[1], width);
    });
}

FieldId smooth_difference(Field& field, FieldId a, FieldId b, NodeId k) {
    const Expr width = positive(field, k);
    return blend(field, {a, b}, [&](const std::vector<Expr>& f) {
        return -polynomial_minimum(-f[0], f[1], width);
    });
}

FieldId offset(Field& field, FieldId a, NodeId d) {
    const Expr by(field.graph, d);
    return blend(field, {a}, [&](const std::vector<Expr>& f) { return f[0] - by; });
}

FieldId shell(Field& field, FieldId a, NodeId thickness) {
    const Expr half = Expr(field.graph, thickness) * 0.5;
    return blend(field, {a}, [&](const std::vector<Expr>& f) { return abs(f[0]) - half; });
}

FieldId displace(Field& field, FieldId a, NodeId by) {
    const auto formula = composed(field, a);
    if (!formula) {
        const FieldId whole = blend(field, {a}, [](const std::vector<Expr>& f) { return f[0]; });
        std::get<Blend>(field.nodes[index(whole)]).displacement = by;
        return whole;
    }
    Formula result = *formula;
    result.exact = false;
    if (result.metric == Metric::distance) {
        result.metric = Metric::scalar;
        result.distortions = {Distortion{{coordinates(field.graph)}, {}}};
    }
    const auto add = [&](NodeId to) { return field.graph.apply(graph::Op::add, to, by); };
    result.value = add(result.value);
    if (!result.minima.empty()) result.outline = add(result.outline);
    for (Distortion& it : result.distortions) {
        it.displacement = it.displacement ? add(*it.displacement) : by;
    }
    return field.add(std::move(result));
}

FieldId morph(Field& field, FieldId a, FieldId b, NodeId t) {
    const Expr part = min(max(Expr(field.graph, t), 0.0), 1.0);
    return blend(field, {a, b},
                 [&](const std::vector<Expr>& f) { return (1.0 - part) * f[0] + part * f[1]; });
}

FieldId choose(Field& field, NodeId less, NodeId than, FieldId a, FieldId b) {
    return field.add(Choice{less, than, a, b});
}

}  // namespace field
