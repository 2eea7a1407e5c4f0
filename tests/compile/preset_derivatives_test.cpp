// SPDX-License-Identifier: MIT
// Gradients and Hessians of all presets' formulas against differences with 113 bits.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "base/file.h"
#include "compile/compile.h"
#include "eval/tape.h"
#include "eval/wide.h"
#include "passes/differentiate.h"
#include "scene/preset.h"

namespace {

namespace fs = std::filesystem;
using eval::Quad;
using graph::NodeId;

const fs::path presets = fs::path(ZEROSET_SOURCE_DIR) / "presets";

struct Values {
    const graph::Graph& graph;
    std::vector<Quad> parameters;
    std::vector<Quad> variables;

    Quad at(NodeId node, const std::array<double, 3>& p, int axis, double step) {
        for (std::size_t i = 0; i < 3; ++i) variables[i] = p[i];
        const auto moved = static_cast<std::size_t>(axis);
        variables[moved] = variables[moved] + Quad(step);
        return eval::values_by_type<Quad>(graph, node, variables, parameters).back();
    }
    Quad difference(NodeId node, const std::array<double, 3>& p, int axis, double h) {
        const auto f = [&](double s) { return at(node, p, axis, s); };
        return (8.0 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / Quad(12 * h);
    }
};

/// How much was compared, and at how many places a derivative is undefined by the chain rule.
struct Count {
    int compared = 0, undefined = 0;
};

/// Compares the derivatives of one node.
void compare(graph::Graph& graph, Values values, NodeId node, std::mt19937_64& random,
             const std::string& name, Count& count, std::array<NodeId, 3>& slopes) {
    slopes = passes::gradient(graph, node);
    std::uniform_real_distribution<double> number(-1, 1);
    for (int trial = 0; trial < 10; ++trial) {
        const std::array p{number(random), number(random), number(random)};
        for (int axis = 0; axis < 3; ++axis) {
            const Quad wide = values.difference(node, p, axis, 2e-6);
            const Quad expected = values.difference(node, p, axis, 1e-6);
            const auto size = static_cast<double>(abs(expected).number);
            // At a kink differences depend on the step; undefined places have none.
            if (!(abs(wide - expected).number <= 1e-12 * (1 + size))) continue;
            const Quad found = values.at(slopes[static_cast<std::size_t>(axis)], p, axis, 0);
            ++(found.is_nan() ? count.undefined : count.compared);
            if (found.is_nan()) continue;
            EXPECT_LE(static_cast<double>(abs(found - expected).number), 1e-12 * (1 + size))
                << name << ", axis " << axis << " at " << ::testing::PrintToString(p);
        }
    }
}

TEST(PresetDerivatives, agree_with_differences_up_to_the_second) {
    constexpr unsigned seed = 57721;
    std::mt19937_64 random(seed);
    Count first, second;
    for (const fs::path& path : scene::list_presets(presets)) {
        const auto text = base::read_text(presets / path, scene::largest_preset);
        ASSERT_TRUE(text) << path;
        const auto preset = scene::read_preset(*text);
        ASSERT_TRUE(preset) << path;
        auto formula = compile::compile_formula(preset->document.formula);
        ASSERT_TRUE(formula) << path;
        field::Field& field = formula->field;
        const std::vector<double> numbers = compile::parameter_values(field, preset->document);
        const auto all = leaves(field, field.root);
        // Of a thousand alike some are enough.
        for (std::size_t i = 0; i < all.size(); i += 1 + all.size() / 30) {
            const field::FieldId id = all[i];
            const auto* leaf = std::get_if<field::Formula>(&field[id]);
            if (!leaf) continue;
            const Values values{field.graph,
                                {numbers.begin(), numbers.end()},
                                std::vector<Quad>(field.graph.variable_count())};
            std::array<NodeId, 3> gradient{}, unused{};
            compare(field.graph, values, leaf->value, random, path, first, gradient);
            for (const NodeId slope : gradient) {
                compare(field.graph, values, slope, random, path, second, unused);
            }
        }
    }
    EXPECT_GT(first.compared, 1000) << "seed " << seed;
    EXPECT_EQ(first.undefined, 0);
    // The second derivative of a length that is 0 all around: inside of a box.
    EXPECT_GT(second.compared, 3000);
    EXPECT_LT(second.undefined, second.compared / 20);
}

}  // namespace
