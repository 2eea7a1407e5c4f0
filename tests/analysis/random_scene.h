// SPDX-License-Identifier: MIT
// Trees of random expressions, and of awkward ones.
#pragma once

#include <vector>

#include "eval/random_expression.h"
#include "field/blends.h"
#include "field/palette.h"

namespace analysis {

/// Some solids of one random graph joined at random, the parameter `p` at 0.7. With `sheets` the
/// leaves are sheets, joined by unions.
struct RandomScene {
    field::Field field;
    std::vector<double> parameters{0, 0.7};

    RandomScene(eval::Random& random, bool sheets) {
        eval::RandomExpression expression =
            eval::random_expression(random, 1 + static_cast<int>(random() % 12));
        field.graph = std::move(expression.graph);
        std::vector<field::FieldId> open;
        const std::size_t count = 1 + random() % 3;
        for (std::size_t i = 0; i < count; ++i) {
            // Later nodes of the graph are the more involved ones.
            const std::size_t back = random() % 4;
            const std::size_t last = field.graph.size() - 1;
            const auto value = static_cast<graph::NodeId>(last - std::min(back * i, last));
            const graph::NodeId level = field.graph.constant(eval::ordinary_number(random));
            const graph::NodeId shifted = field.graph.apply(graph::Op::sub, value, level);
            open.push_back(field.add(field::Formula{
                shifted, field::Metric::scalar, sheets ? field::Kind::sheet : field::Kind::solid}));
        }
        while (open.size() > 1) {
            const field::FieldId a = open.back();
            open.pop_back();
            open.back() = field.add(join(random, a, open.back(), sheets));
        }
        field.root = open.back();
        if (!sheets && random() % 4 == 0) field.root = field.add(field::Complement{field.root});
    }

private:
    /// A colour, so that formulas are blended and not composed.
    field::Colour red() {
        return {field.graph.constant(1), field.graph.constant(0), field.graph.constant(0)};
    }

    field::Node join(eval::Random& random, field::FieldId a, field::FieldId b, bool sheets) {
        switch (sheets ? 0 : random() % 3) {
            case 0:
                return field::Union{a, b};
            case 1:
                return field::Intersection{a, b};
            default:
                return field[field::smooth_union(field, field::coloured(field, a, red()), b,
                                                 field.graph.constant(0.5))];
        }
    }
};

}  // namespace analysis
