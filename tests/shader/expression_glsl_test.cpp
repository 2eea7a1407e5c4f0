// SPDX-License-Identifier: MIT
// Expressions as GLSL statements, and numbers as GLSL literals.
#include "shader/expression_glsl.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <regex>

#include "eval/random_expression.h"
#include "graph/build.h"

namespace shader {
namespace {

using graph::Expr;

double read_back(std::string text) {
    const bool negative = text.starts_with('(');
    if (negative) text = text.substr(2, text.size() - 3);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    EXPECT_EQ(end, text.data() + text.size()) << text;
    EXPECT_EQ(error, std::errc()) << text;
    return negative ? -value : value;
}

TEST(Literal, is_short_and_never_a_whole_number) {
    EXPECT_EQ(literal(0), "0.0");
    EXPECT_EQ(literal(1), "1.0");
    EXPECT_EQ(literal(0.1), "0.1");
    EXPECT_EQ(literal(1e30), "1e+30");
    EXPECT_EQ(literal(-2), "(-2.0)");
    EXPECT_EQ(literal(-0.0), "(-0.0)");
}

TEST(Literal, reads_back_as_the_same_number) {
    constexpr unsigned seed = 51;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> exponent(-120, 120);
    for (int i = 0; i < 10000; ++i) {
        const double sign = i % 2 == 0 ? 1 : -1;
        const double value = sign * std::exp2(exponent(random));
        ASSERT_EQ(read_back(literal(value)), value) << "seed " << seed;
    }
}

TEST(Literal, stays_within_single_precision) {
    constexpr double largest = std::numeric_limits<float>::max();
    for (const double value : {1e39, 1e300, std::numeric_limits<double>::infinity()}) {
        EXPECT_EQ(read_back(literal(value)), largest);
        EXPECT_EQ(read_back(literal(-value)), -largest);
    }
}

/// A graph, and the writer of one function over p.
struct Function {
    graph::Graph graph;
    FieldValues values;

    Expr x{graph, graph.variable(graph::variable_x)};
    Expr y{graph, graph.variable(graph::variable_y)};
    Expr t{graph, graph.parameter(graph::parameter_t)};

    Function() = default;
    Function(const Function&) = delete;
    Function& operator=(const Function&) = delete;

    std::string write(Expr root) {
        const std::vector<bool> depends = depends_on_variables(graph);
        ExpressionWriter writer(graph, depends, values,
                                {{graph::variable_x, "p.x"}, {graph::variable_y, "p.y"}});
        const std::string text = writer.statements(std::array{root.id}, "  ");
        parts = writer.operator_parts();
        return text + "= " + writer.spelling(root.id);
    }
    std::set<std::string> parts{};
};

TEST(ExpressionWriter, writes_one_statement_for_each_node) {
    Function f;
    const Expr shared = f.x * f.y;
    const Expr wave = sin(shared), part = shared / -2.0;
    EXPECT_EQ(f.write(wave - part),
              "  real n0 = p.x * p.y;\n"
              "  real n1 = zs_sin(n0);\n"
              "  real n2 = n0 / (-2.0);\n"
              "  real n3 = n1 - n2;\n"
              "= n3");
    EXPECT_EQ(f.parts, std::set<std::string>{"operator/sin.glsl"});
}

TEST(ExpressionWriter, spells_prefix_signs_and_functions) {
    Function f;
    EXPECT_EQ(f.write(-hypot(f.x, f.y)),
              "  real n0 = zs_hypot(p.x, p.y);\n"
              "  real n1 = -n0;\n"
              "= n1");
}

TEST(ExpressionWriter, asks_once_for_sine_and_cosine_of_one_argument) {
    Function f;
    const Expr sum = f.x + f.y;
    EXPECT_EQ(f.write(cos(sum) * sin(sum) - sin(f.x)),
              "  real n0 = p.x + p.y;\n"
              "  real n1 = zs_sin(p.x);\n"
              "  real2 n2 = zs_sincos(n0);\n"
              "  real n3 = n2.y * n2.x;\n"
              "  real n4 = n3 - n1;\n"
              "= n4");
}

/// The names that are declared, and how often each occurs after its own declaration.
std::map<std::string, int> uses(const std::string& text) {
    std::map<std::string, int> count;
    const std::regex name("\\bn[0-9]+");
    for (auto i = std::sregex_iterator(text.begin(), text.end(), name); i != std::sregex_iterator();
         ++i) {
        const auto [place, fresh] = count.try_emplace(i->str(), 0);
        if (!fresh) ++place->second;
    }
    return count;
}

TEST(ExpressionWriter, writes_nothing_dead) {
    constexpr unsigned seed = 314;
    eval::Random random(seed);
    for (int trial = 0; trial < 200; ++trial) {
        const auto [graph, root] = eval::random_expression(random, 40);
        const std::vector<bool> depends = depends_on_variables(graph);
        FieldValues values;
        ExpressionWriter writer(
            graph, depends, values,
            {{graph::variable_x, "p.x"}, {graph::variable_y, "p.y"}, {graph::variable_z, "p.z"}});
        const std::string statements = writer.statements(std::array{root}, "");
        for (const auto& [name, count] : uses(statements + writer.spelling(root))) {
            ASSERT_GT(count, 0) << name << " is never used, seed " << seed << ":\n" << statements;
        }
        const auto needed = reachable(graph, std::array{root});
        for (const graph::NodeId id : values.expressions()) {
            ASSERT_TRUE(std::ranges::binary_search(needed, id)) << "seed " << seed;
        }
    }
}

TEST(ExpressionWriter, needs_no_statement_for_leaves) {
    Function f;
    EXPECT_EQ(f.write(f.x), "= p.x");
    EXPECT_EQ(f.write(Expr(f.graph, -3.0)), "= (-3.0)");
}

TEST(ExpressionWriter, leaves_what_does_not_depend_on_the_point_to_the_cpu) {
    Function f;
    const Expr turn = sin(f.t * 2.0) + 1.0;
    EXPECT_EQ(f.write(f.x * turn + turn),
              "  real n0 = p.x * field_values[0].x;\n"
              "  real n1 = n0 + field_values[0].x;\n"
              "= n1");
    EXPECT_EQ(f.values.expressions(), std::vector{turn.id});
    EXPECT_TRUE(f.parts.empty()) << "no sine on the GPU";
}

TEST(FieldValues, fill_four_places_of_each_vector) {
    graph::Graph graph;
    FieldValues values;
    for (int i = 0; i < 6; ++i) {
        const graph::NodeId node = graph.parameter(graph.new_parameter("p"));
        EXPECT_EQ(values.expression(node), "field_values[" + std::to_string(i / 4) + "]." +
                                               std::string("xyzw").substr(i % 4, 1));
    }
    const graph::NodeId again = values.expressions()[2];
    EXPECT_EQ(values.expression(again), "field_values[0].z") << "one place for one node";
    EXPECT_EQ(values.bound({FieldValue::What::first_order, field::FieldId{}, {}}),
              "field_values[1].z");
    EXPECT_EQ(values.list().size(), 7U);
    EXPECT_EQ(values.expressions().size(), 6U);
}

}  // namespace
}  // namespace shader
