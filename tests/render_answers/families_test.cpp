// SPDX-License-Identifier: MIT
// Pictures of many operands that are data of their program, against the same operands as text.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <fmt/format.h>

#include "compile/compile.h"
#include "headless.h"
#include "render_answers/shot.h"

namespace render_answers {
namespace {

const shader::Outputs everything{.picture = true, .geometry = true, .normal = true};

/// The whole picture, with the operands of large unions as data or as text.
render::Still drawn(const scene::Document& document, bool as_text) {
    const auto formula = compile::compile_formula(document.formula);
    auto context = open_headless();
    if (!formula || !context) {
        ADD_FAILURE() << document.formula << (formula ? "" : formula.problems()[0].message);
        return {};
    }
    shader::Features features = compile::features(*formula, document, everything);
    features.operands_as_text = as_text;
    const shader::ProgramSource source = shader::program_source(formula->field, features);
    EXPECT_EQ(source.families.empty(), as_text) << document.formula;
    const shader::FieldNumbers numbers = compile::field_numbers(*formula, source, document);
    const render::View view = render::whole(100, 75);
    const scene::Camera camera = scene::camera_of(document, 4.0 / 3);
    const auto frame_of = [&](const render::View& part) {
        return render::frame(document, camera, part);
    };
    auto still = render::draw_still(**context, source, numbers, frame_of, view, everything);
    if (!still) {
        ADD_FAILURE() << document.formula << ": " << still.problems()[0].message;
        return {};
    }
    return std::move(*still);
}

/// Text that gives `count` fields names f1, f2, ..., at random places, and their list.
std::string operands(std::mt19937& random, int count, const std::string& form, std::string& list) {
    std::uniform_real_distribution<double> place(-1, 1), unit(0, 1);
    std::string text;
    for (int i = 1; i <= count; ++i) {
        const auto point = [&] {
            return fmt::format("({:.4f}, {:.4f}, {:.4f})", place(random), place(random),
                               place(random));
        };
        // Every eighth lies in a plane of coordinates.
        const std::string where =
            i % 8 == 0 ? fmt::format("({:.4f}, 0, {:.4f})", place(random), place(random)) : point();
        const std::string field =
            fmt::format(fmt::runtime(form), fmt::arg("a", 0.05 + 0.1 * unit(random)),
                        fmt::arg("v", point()), fmt::arg("u", unit(random)));
        text += fmt::format("f{} = translate({}, {})\n", i, field, where);
        list += fmt::format("{}f{}", i > 1 ? ", " : "", i);
    }
    return text;
}

struct Case {
    const char* form;   ///< of an operand, with numbers a and u and a vector v
    const char* whole;  ///< of the list
};

TEST(Families, look_as_the_same_operands_do_as_text) {
    const std::uint32_t seed = 20261122;
    std::mt19937 random(seed);
    const std::vector<Case> cases{
        {"sphere({a})", "union({})"},
        {"rotate(box({a}, 0.1, 0.06), {v}, 360 * {u})", "union({})"},
        {"sphere({a})", "smooth_union({}, 0.1)"},
        {"torus(0.15, 0.4 * {a})", "smooth_union({}, k = 0.3)"},
        {"sphere({a})", "box(0.9, 0.8, 0.7) \\ union({})"},
        {"sphere({a})", "smooth_difference(box(0.9, 0.8, 0.7), union({}), 0.05)"},
        {"sphere({a})", "smooth_difference(sphere(1), smooth_union({}, k = 0.1), 0.05)"},
        {"colour(sphere({a}), {u})", "union({})"},
        {"colour(box({a}), ({u}, abs(x), 0.2))", "union({}) | plane(0, 1, 0, -0.9)"},
        {"sphere({a})", "scale(rotate(union({}), (1, 2, 3), 40), 0.8)"},
        {"sphere({a})", "scale(offset(smooth_union({}, 0.1), 0.02), 0.8)"},
        {"sphere({a})", "repeat(scale(union({}), 0.5), (1, 1, 1))"},
        {"sphere({a})", "colour(repeat_polar(smooth_union({}, 0.1), 3), y)"},
        {"sphere({a})", "displace(smooth_union({}, 0.1), 0.02 sin(20x))"},
        {"sphere(3 * {a})", "x + y + z = 0.2 & union({})"},
    };
    for (const auto& [form, whole] : cases) {
        std::string list;
        Query query;
        query.formula = operands(random, 40, form, list);
        query.formula += fmt::format(fmt::runtime(whole), list);
        query.bounds = sphere_bounds(1.6);
        query.camera = camera({2.2, 1.8, 3.6});
        scene::Document document = document_of(query);
        // Rays stop at other places before what they graze: the nearer the more alike.
        document.settings.epsilon = 0.01;
        const render::Still data = drawn(document, false), text = drawn(document, true);
        int others = 0, different_colours = 0;
        for (int j = 0; j < text.geometry.height; ++j) {
            for (int i = 0; i < text.geometry.width; ++i) {
                const bool hit = status(text, i, j) == shader::Status::hit;
                const bool same = status(data, i, j) == status(text, i, j) &&
                                  (!hit || data.geometry.at(i, j)[3] == text.geometry.at(i, j)[3]);
                const double a = depth(data, i, j), b = depth(text, i, j);
                if (!same || (std::isfinite(b) && std::abs(a - b) > 1e-5 * b)) ++others;
                for (int k = 0; k < 3; ++k) {
                    const int step = data.picture.at(i, j)[k] - text.picture.at(i, j)[k];
                    different_colours += std::abs(step) > 4;
                }
            }
        }
        // Rays that graze an edge are told apart by the last bit.
        EXPECT_LE(others, 4) << "seed " << seed << ": " << query.formula;
        EXPECT_LE(different_colours, 12) << "seed " << seed << ": " << query.formula;
        EXPECT_GT(count(text, shader::Status::hit), 300) << query.formula;
    }
}

TEST(Families, move_with_parameters) {
    std::mt19937 random(5);
    std::string list;
    Query query;
    query.camera = camera({2.6, 2.1, 4.2});
    query.formula = "param s = 0 in [0, 1]\n" +
                    operands(random, 30, "translate(sphere({a} + s/10), (0, s * {u}, 0))", list) +
                    "union(" + list + ")";
    scene::Document document = document_of(query);
    const auto formula = compile::compile_formula(document.formula);
    ASSERT_TRUE(formula);
    const shader::ProgramSource source = compile::program_source(*formula, document, everything);
    const shader::FieldNumbers before = compile::field_numbers(*formula, source, document);
    EXPECT_TRUE(before == compile::field_numbers(*formula, source, document));
    document.parameters["s"] = 0.8;
    EXPECT_FALSE(before == compile::field_numbers(*formula, source, document));
    const render::Still data = drawn(document, false), text = drawn(document, true);
    EXPECT_NEAR(count(data, shader::Status::hit), count(text, shader::Status::hit), 3);
    EXPECT_GT(count(text, shader::Status::hit), 300);
}

TEST(Families, may_have_a_parameter_in_common) {
    std::mt19937 random(15);
    std::string list;
    Query query;
    query.camera = camera({2.6, 2.1, 4.2});
    query.formula = "param s = 0.1 in [0, 1]\n" + operands(random, 30, "sphere(s)", list) +
                    "union(" + list + ")";
    scene::Document document = document_of(query);
    int last = 0;
    for (const double size : {0.1, 0.3}) {
        document.parameters["s"] = size;
        const render::Still data = drawn(document, false), text = drawn(document, true);
        EXPECT_NEAR(count(data, shader::Status::hit), count(text, shader::Status::hit), 3);
        EXPECT_GT(count(text, shader::Status::hit), last + 100);
        last = count(text, shader::Status::hit);
    }
}

TEST(Families, are_right_beyond_their_grid) {
    std::mt19937 random(6);
    std::string list;
    Query query;
    query.formula = operands(random, 30, "sphere({a})", list) + "scale(union(" + list + "), 3)";
    query.bounds = no_bounds();
    query.camera = camera({6, 4.5, 9});
    const scene::Document document = document_of(query);
    const render::Still data = drawn(document, false), text = drawn(document, true);
    int others = 0;
    for (int j = 0; j < text.geometry.height; ++j) {
        for (int i = 0; i < text.geometry.width; ++i) {
            const double a = depth(data, i, j), b = depth(text, i, j);
            others += std::isfinite(a) != std::isfinite(b) ||
                      (std::isfinite(b) && std::abs(a - b) > 1e-5 * b);
        }
    }
    EXPECT_LE(others, 2);
    EXPECT_GT(count(text, shader::Status::hit), 300);
}

}  // namespace
}  // namespace render_answers
