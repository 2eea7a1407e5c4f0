// SPDX-License-Identifier: MIT
// What a program holds, and what it leaves out.
#include "shader/program_source.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "shader/programs.h"

namespace shader {
namespace {

constexpr const char* plain = "x^2 + y^2 + z^2 = 1";

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

std::string program(const char* formula, const Features& features) {
    return program_source(field_of(formula), features).fragment;
}

TEST(ProgramSource, is_the_same_text_every_time) {
    for (const char* text : formulas) {
        const ProgramSource a = program_source(field_of(text), {});
        const ProgramSource b = program_source(field_of(text), {});
        EXPECT_EQ(a.fragment, b.fragment) << text;
        EXPECT_EQ(a.vertex, b.vertex);
        EXPECT_EQ(a.field_values.size(), b.field_values.size());
    }
}

TEST(ProgramSource, does_not_depend_on_the_initial_value_of_a_parameter) {
    const auto with = [](const char* value) {
        return program(
            (std::string("param a = ") + value + " in [0, 9]\nx^2 + a*y = sin(a)").c_str(), {});
    };
    EXPECT_EQ(with("1"), with("2.5"));
    const auto sliced = [](const char* value) {
        return program((std::string("param n = ") + value + " in [1, 9]\nmenger(n)").c_str(), {});
    };
    EXPECT_EQ(sliced("2"), sliced("4"));
}

TEST(ProgramSource, has_shadows_only_if_they_are_on) {
    Features features;
    for (const char* text : formulas) {
        features.shadows = false;
        EXPECT_FALSE(has(lower(program(text, features)), "shadow")) << text;
        features.shadows = true;
        EXPECT_TRUE(has(lower(program(text, features)), "shadow")) << text;
    }
}

TEST(ProgramSource, has_the_grid_only_if_it_is_on) {
    Features features;
    features.grid = false;
    EXPECT_FALSE(has(lower(program(plain, features)), "grid"));
    features.grid = true;
    EXPECT_TRUE(has(program(plain, features), "grid_line("));
}

TEST(ProgramSource, has_a_pre_pass_only_if_tiles_are_wanted) {
    const ProgramSource without = program_source(field_of(plain), {});
    EXPECT_EQ(without.prepass, "");
    EXPECT_FALSE(has(without.fragment, "tile_parts"));
    Features features;
    features.whole_tiles = true;
    const ProgramSource with = program_source(field_of(plain), features);
    EXPECT_TRUE(has(with.prepass, "write_tile("));
    EXPECT_FALSE(has(with.prepass, "shade("));
    EXPECT_FALSE(has(with.prepass, "Trace trace("));
    EXPECT_TRUE(has(with.fragment, "texelFetch(tile_parts"));
    EXPECT_FALSE(with.same_text(without));
    EXPECT_TRUE(with.same_text(program_source(field_of(plain), features)));
}

TEST(ProgramSource, goes_by_balls_only_where_all_answers_are) {
    for (const char* text : {"mandelbulb()", "menger(3) & sphere(1)", "sphere(1) \\ julia()"}) {
        const ProgramSource source = program_source(field_of(text), {});
        EXPECT_TRUE(has(source.prepass, "zs_guess || r <= spread * t")) << text;
        EXPECT_TRUE(has(source.fragment, "ball_reach(")) << text;
        EXPECT_FALSE(has(source.fragment, "Settled")) << text;
    }
    for (const char* text : {"sphere(1)", "mandelbulb() | x*y <= 1", "repeat(menger(2), (3, 3, 3))",
                             "smooth_union(menger(2), sphere(1), 0.1)", "twist(menger(2), z)"}) {
        const ProgramSource source = program_source(field_of(text), {});
        EXPECT_EQ(source.prepass, "") << text;
        EXPECT_FALSE(has(source.fragment, "ball_reach(")) << text;
    }
    for (const char* tracer : {"march", "relaxed", "interval"}) {
        Features features;
        features.tracer = tracer;
        EXPECT_EQ(program_source(field_of("menger(3)"), features).prepass, "") << tracer;
    }
}

TEST(ProgramSource, shades_nothing_that_is_not_drawn) {
    Features features;
    features.grid = true;
    features.show_steps = true;
    EXPECT_FALSE(has(program(plain, features), "shade("));
    EXPECT_FALSE(has(lower(program(plain, features)), "shadow"));
    EXPECT_FALSE(has(program(plain, features), "grid_line("));
    features.show_steps = false;
    features.outputs = {.picture = false, .geometry = true, .normal = false, .count = false};
    const std::string geometry = program(plain, features);
    for (const char* part : {"shade(", "shadow", "display(", "picture_out", "normal_out"}) {
        EXPECT_FALSE(has(geometry, part)) << part;
    }
    EXPECT_TRUE(has(geometry, "geometry_out = "));
}

TEST(ProgramSource, has_only_the_operators_that_the_formula_needs) {
    const std::string text = program("sin(x)*y = z", {});
    EXPECT_TRUE(has(text, "real zs_sin("));
    graph::for_each_operator([&](graph::Op op) {
        const std::string_view file = graph::facts(op).glsl_file;
        if (file.empty() || file == "sin") return;
        EXPECT_FALSE(has(text, "real " + std::string(graph::facts(op).glsl) + "("))
            << graph::facts(op).name;
    });
}

TEST(ProgramSource, has_only_the_kinds_of_leaves_that_the_formula_needs) {
    const std::string sphere = program("sphere(1)", {});
    EXPECT_TRUE(has(sphere, "Answer distance_answer("));
    for (const char* part : {"sheet_answer", "formula_answer", "iteration_answer", "blend_answer",
                             "field_values", "object_differences"}) {
        EXPECT_FALSE(has(sphere, part)) << part;
    }
    EXPECT_FALSE(has(program(plain, {}), "iteration_answer"));
}

TEST(ProgramSource, has_one_way_to_step_and_one_region) {
    for (const TracerName& tracer : tracers()) {
        Features features;
        features.tracer = tracer.name;
        const std::string text = program(plain, features);
        const std::size_t first = text.find("real formula_step(");
        ASSERT_NE(first, std::string::npos) << tracer.name;
        EXPECT_EQ(text.find("real formula_step(", first + 1), std::string::npos) << tracer.name;
        EXPECT_FALSE(tracer.summary.empty());
    }
    Features sphere, box, none;
    box.bounds_sphere = none.bounds_sphere = false;
    box.bounds_box = true;
    EXPECT_NE(program(plain, sphere), program(plain, box));
    EXPECT_NE(program(plain, box), program(plain, none));
    EXPECT_NE(program(plain, none), program(plain, sphere));
}

TEST(ProgramSource, tells_tracers_apart_and_takes_an_unknown_one_for_the_first) {
    Features features;
    std::set<std::string> texts;
    for (const TracerName& tracer : tracers()) {
        features.tracer = tracer.name;
        texts.insert(program(plain, features));
    }
    EXPECT_EQ(texts.size(), tracers().size());
    features.tracer = "no such tracer";
    EXPECT_EQ(program(plain, features), program(plain, {}));
    EXPECT_EQ(tracers()[0].name, "auto");
}

TEST(ProgramSource, has_second_derivatives_only_for_the_second_order) {
    Features features;
    for (const TracerName& tracer : tracers()) {
        features.tracer = tracer.name;
        const bool second = tracer.name == "second-order";
        for (const char* text : formulas) {
            const field::Field field = field_of(text);
            const std::string code = program_source(field, features).fragment;
            for (const char* part : {"hessian_norm", "out real m"}) {
                if (!second) {
                    EXPECT_FALSE(has(code, part)) << tracer.name << ": " << text;
                }
            }
        }
        const std::string code = program("x^3*y = sin(z)", features);
        EXPECT_EQ(has(code, "m = hessian_norm(real3("), second) << tracer.name;
        EXPECT_EQ(has(code, "field_values"), !second) << "bounds of the region are of no use";
        const bool along = tracer.name == "auto";
        EXPECT_EQ(has(program("x^3*y = z", features), "field_values"), !second && !along)
            << "nor to polynomials along the ray";
    }
}

TEST(ProgramSource, has_one_way_to_stride) {
    Features features;
    for (const TracerName& tracer : tracers()) {
        features.tracer = tracer.name;
        const std::string code = program(plain, features);
        EXPECT_EQ(has(code, "zs_sign_only"), tracer.name == "march") << tracer.name;
        EXPECT_EQ(has(code, "zs_relaxation"), tracer.name == "relaxed") << tracer.name;
    }
}

TEST(ProgramSource, has_no_comments) {
    for (const char* text : formulas) {
        const ProgramSource source = program_source(field_of(text), {});
        for (const std::string& code : {source.fragment, source.vertex}) {
            EXPECT_FALSE(has(code, "//")) << text;
            EXPECT_TRUE(code.starts_with("#version 450 core\n")) << text;
        }
    }
}

TEST(ProgramSource, declares_as_many_field_values_as_it_lists) {
    for (const char* text : formulas) {
        const ProgramSource source = program_source(field_of(text), {});
        const std::size_t vectors = (source.field_values.size() + 3) / 4;
        const std::string block = "vec4 field_values[" + std::to_string(vectors) + "];";
        EXPECT_EQ(has(source.fragment, block), vectors > 0) << text;
        const auto expressions = std::ranges::count(
            source.field_values, FieldValue::What::expression, &FieldValue::what);
        EXPECT_EQ(static_cast<std::size_t>(expressions), source.expressions.roots.size()) << text;
    }
}

}  // namespace
}  // namespace shader
