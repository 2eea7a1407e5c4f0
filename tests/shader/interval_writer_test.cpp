// SPDX-License-Identifier: MIT
// What encloses an expression over intervals.
#include "shader/interval_writer.h"

#include <gtest/gtest.h>

#include "graph/build.h"
#include "shader/field_glsl.h"
#include "shader/parts.h"
#include "shader/programs.h"

namespace shader {
namespace {

/// The statements of f(x, y), and how the result is spelt.
template <class Function>
std::string written(Function function) {
    graph::Graph graph;
    const graph::Expr x(graph, graph.variable(graph::variable_x));
    const graph::Expr y(graph, graph.variable(graph::variable_y));
    const graph::NodeId root = function(x, y).id;
    const std::vector<bool> depends = depends_on_variables(graph);
    FieldValues values;
    IntervalWriter writer(graph, depends, values,
                          {{graph::variable_x, "x"}, {graph::variable_y, "y"}});
    const std::string statements = writer.statements(root, "");
    return statements + writer.spelling(root);
}

TEST(IntervalWriter, calls_the_operator_over_intervals) {
    EXPECT_EQ(written([](auto x, auto y) { return x + y; }), "real2 i0 = interval_add(x, y);\ni0");
    EXPECT_EQ(written([](auto x, auto y) { return sin(x * y); }),
              "real2 i0 = interval_mul(x, y);\nreal2 i1 = interval_sin(i0);\ni1");
}

TEST(IntervalWriter, knows_squares_and_multiples) {
    EXPECT_EQ(written([](auto x, auto) { return x * x; }), "real2 i0 = interval_square(x);\ni0");
    EXPECT_EQ(written([](auto x, auto) { return -2.5 * x; }),
              "real2 i0 = interval_scaled(x, (-2.5));\ni0");
}

TEST(IntervalWriter, encloses_numbers_that_single_precision_has_not) {
    EXPECT_EQ(written([](auto x, auto) { return x + 0.5; }),
              "real2 i0 = interval_add(x, real2(0.5));\ni0");
    EXPECT_EQ(written([](auto x, auto) { return 0.1 * x; }),
              "real2 i0 = interval_mul(real2(0.09999999403953552, 0.10000000894069672), x);\ni0");
    EXPECT_EQ(written([](auto x, auto) { return x + 1e300; }),
              "real2 i0 = interval_add(x, real2(3.4028232635611926e+38, zs_all().y));\ni0");
}

TEST(IntervalWriter, encloses_what_the_frame_hands_over) {
    graph::Graph graph;
    const graph::NodeId a = graph.parameter(graph.new_parameter("a"));
    const std::vector<bool> depends = depends_on_variables(graph);
    FieldValues values;
    IntervalWriter writer(graph, depends, values, {});
    EXPECT_EQ(writer.spelling(a), "interval_about(field_values[0].x)");
}

TEST(Enclosures, are_of_formulas_and_ask_all_else_at_a_point) {
    const Demands intervals{.intervals = true};
    const auto code = [&](const char* text) {
        return field_glsl(field_of(text), false, intervals).code;
    };
    const std::string sheet = code("x*y = z");
    EXPECT_TRUE(has(sheet, "return sheet_enclosure("));
    EXPECT_FALSE(has(sheet, "answer_enclosure"));
    EXPECT_TRUE(has(code("sphere(1) | x*y <= z"), "enclosure_union(e0, e1, false)"));
    EXPECT_TRUE(has(code("x*y = z & sphere(1)"), "enclosure_intersection(e0, e1, true)"));
    EXPECT_TRUE(has(code("menger(2)"), "answer_enclosure(leaf_0(p, d), t)"));
    const std::string mixed = code("sphere(1) | repeat(box(0.1), (1, 1, 1)) | julia()");
    EXPECT_TRUE(has(mixed, "Answer part_0(real3 p, real3 d)"));
    EXPECT_TRUE(has(mixed, "answer_enclosure(part_0(p, d), t)"));
    EXPECT_TRUE(has(mixed, "answer_enclosure(leaf_2(p, d), t)"));
    EXPECT_FALSE(has(mixed, "part_1"));
}

TEST(Enclosures, are_in_programs_of_the_interval_tracer_only) {
    Features features;
    for (const TracerName& tracer : tracers()) {
        features.tracer = tracer.name;
        for (const char* text : formulas) {
            const std::string code = program_source(field_of(text), features).fragment;
            EXPECT_EQ(has(code, "nclosure"), tracer.name == "interval") << tracer.name << text;
            if (tracer.name == "interval") continue;
            EXPECT_FALSE(has(code, "interval_")) << tracer.name << text;
        }
    }
}

TEST(Enclosures, know_every_operator) {
    graph::for_each_operator([&](graph::Op op) {
        EXPECT_TRUE(parts().contains("interval/" + std::string(graph::facts(op).name) + ".glsl"))
            << graph::facts(op).name;
    });
}

}  // namespace
}  // namespace shader
