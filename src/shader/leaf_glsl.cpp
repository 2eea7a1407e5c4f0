// SPDX-License-Identifier: MIT
// The functions of leaves.
#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "shader/field_code.h"
#include "shader/iteration_glsl.h"

namespace shader {
namespace {

using graph::NodeId;

std::string bound(FieldCode& code, FieldValue::What what, std::size_t object) {
    const Object& it = code.plan.objects[object];
    return code.values.bound({what, it.id, it.cells});
}

void write_iteration(FieldCode& code, std::size_t i, const field::Iteration& iteration) {
    ExpressionWriter w = code.writer();
    code.out.code += fmt::format("real value_{}(real3 p, out bool inside) {{\n", i);
    code.out.code += iteration_body(code.field.graph, iteration, w, code.values);
    code.out.code += "}\n";
    const std::string answer =
        iteration.image ? fmt::format("distorted_answer(f, inside, {}, ",
                                      bound(code, FieldValue::What::inverse_lipschitz, i))
                        : "iteration_answer(f, inside, ";
    code.out.code += fmt::format(
        "Answer leaf_{0}(real3 p, real3 d) {{\n"
        "    bool inside;\n"
        "    real f = value_{0}(p, inside);\n"
        "    return {2}{1}, {0});\n"
        "}}\n",
        i, iteration.escape ? "4.0" : "1.0", answer);
    code.finish(w);
    code.needs("leaf/iteration.glsl");
    const auto gradient = code.orbit_gradients.find(code.plan.objects[i].id);
    if (gradient == code.orbit_gradients.end()) return;
    ExpressionWriter slopes = code.writer();
    code.out.code += fmt::format(
        "real3 gradient_{}(real3 p) {{\n{}}}\n", i,
        iteration_gradient(code.field.graph, iteration, gradient->second, slopes, code.values));
    code.finish(slopes);
}

/// What a value's minima add to its gradient.
std::string gradients_of_minima(const FieldCode& code, std::size_t i, ExpressionWriter& w) {
    const auto found = code.minima.find(i);
    if (found == code.minima.end()) return {};
    std::string text;
    for (const auto& [variable, family] : found->second) {
        const NodeId weight = code.minima_weights.at(code.plan.objects[i].id).at(variable);
        text += w.statements(std::array{weight}, "    ");
        text += fmt::format("    g += {} * g_{};\n", w.spelling(weight), family);
    }
    return text;
}

/// Value and gradient in one function.
void write_value_and_gradient(FieldCode& code, std::size_t i, const field::Formula& leaf) {
    ExpressionWriter w = code.writer();
    const Gradient& g = code.gradients.at(code.plan.objects[i].id);
    const std::array roots{leaf.value, g[0], g[1], g[2]};
    code.out.code += fmt::format("real value_{}(real3 p, out real3 g) {{\n", i);
    if (const CodedTree* tree = tree_of(code, i)) {
        code.out.code += fmt::format("    FamilyCell cell = {};\n", tree->cell);
    }
    code.out.code += minima_statements(code, i, w, true);
    code.out.code += w.statements(roots, "    ");
    code.out.code += fmt::format("    g = real3({}, {}, {});\n", w.spelling(roots[1]),
                                 w.spelling(roots[2]), w.spelling(roots[3]));
    code.out.code += gradients_of_minima(code, i, w);
    code.out.code += fmt::format("    return {};\n}}\n", w.spelling(roots[0]));
    code.finish(w);
}

void write_distance(FieldCode& code, std::size_t i, const field::Formula& leaf) {
    ExpressionWriter w = code.writer();
    const CodedTree* tree = tree_of(code, i);
    code.out.code +=
        fmt::format("real distance_{}(real3 p{}) {{\n", i, tree ? ", FamilyCell cell" : "");
    code.out.code += minima_statements(code, i, w, false);
    code.out.code += w.statements(std::array{leaf.value}, "    ");
    code.out.code += fmt::format("    return {};\n}}\n", w.spelling(leaf.value));
    code.finish(w);
    write_value_and_gradient(code, i, leaf);
    if (!tree) {
        code.out.code += fmt::format(
            "Answer leaf_{0}(real3 p, real3 d) {{ return distance_answer(distance_{0}(p), {0}); "
            "}}\n",
            i);
    } else {
        code.out.code += fmt::format(
            "real distance_{0}(real3 p) {{ return distance_{0}(p, {1}); }}\n"
            "Answer leaf_{0}(real3 p, real3 d) {{\n"
            "    FamilyCell cell = {1};\n"
            "{2}"
            "    return distance_answer(distance_{0}(p, cell), {0});\n"
            "}}\n",
            i, tree->cell, far_statement(*tree, i));
    }
    code.needs("leaf/distance.glsl");
}

/// Value, gradient and the norm of the Hessian in one function.
void write_second_order(FieldCode& code, std::size_t i, const field::Formula& leaf,
                        const Hessian& h) {
    ExpressionWriter w = code.writer();
    const Gradient& g = code.gradients.at(code.plan.objects[i].id);
    const std::array roots{leaf.value, g[0], g[1], g[2], h[0], h[1], h[2], h[3], h[4], h[5]};
    code.out.code += fmt::format("real value_{}(real3 p, out real3 g, out real m) {{\n", i);
    code.out.code += w.statements(roots, "    ");
    std::array<std::string, 10> s;
    std::ranges::transform(roots, s.begin(), [&](NodeId root) { return w.spelling(root); });
    code.out.code += fmt::format(
        "    g = real3({}, {}, {});\n"
        "    m = hessian_norm(real3({}, {}, {}), real3({}, {}, {}));\n"
        "    return {};\n}}\n",
        s[1], s[2], s[3], s[4], s[5], s[6], s[7], s[8], s[9], s[0]);
    code.finish(w);
}

/// What the step knows of a leaf's derivatives in the region.
std::string region_bounds(FieldCode& code, std::size_t i) {
    // One after the other: the order of arguments is the compiler's choice.
    const std::string lipschitz = bound(code, FieldValue::What::inverse_lipschitz, i);
    const std::string second = bound(code, FieldValue::What::second_derivative, i);
    const std::string first = bound(code, FieldValue::What::first_order, i);
    return fmt::format("real3({}, {}, {})", lipschitz, second, first);
}

/// How far along the ray the formula jumps next. True if it jumps anywhere.
bool write_jumps(FieldCode& code, std::size_t i) {
    const auto found = code.jump_walls.find(code.plan.objects[i].id);
    if (found == code.jump_walls.end()) return false;
    const std::vector<Gradient>& rates = code.jump_rates.at(found->first);
    std::vector<NodeId> roots = found->second;
    for (const Gradient& rate : rates) roots.insert(roots.end(), rate.begin(), rate.end());
    ExpressionWriter w = code.writer();
    code.out.code += fmt::format("real jump_{}(real3 p, real3 d) {{\n{}    real wall = zs_far;\n",
                                 i, w.statements(roots, "    "));
    for (std::size_t k = 0; k < rates.size(); ++k) {
        code.out.code +=
            fmt::format("    wall = min(wall, cell_exit({}, dot(real3({}, {}, {}), d)));\n",
                        w.spelling(found->second[k]), w.spelling(rates[k][0]),
                        w.spelling(rates[k][1]), w.spelling(rates[k][2]));
    }
    code.out.code += "    return wall;\n}\n";
    code.finish(w);
    code.needs("leaf/cells.glsl");
    return true;
}

/// The answer by value and gradient at the point.
void write_scalar(FieldCode& code, std::size_t i, const field::Formula& leaf) {
    write_value_and_gradient(code, i, leaf);
    const auto hessian = code.hessians.find(code.plan.objects[i].id);
    const bool second_order = hessian != code.hessians.end();
    if (second_order) write_second_order(code, i, leaf, hessian->second);
    const std::optional<std::size_t> grid = code.brick_grid(i);
    const std::string bounds = second_order ? "real3(0.0, m, 0.0)"
                               : grid       ? "brick.bounds"
                                            : region_bounds(code, i);
    const bool sheet = leaf.kind == field::Kind::sheet;
    std::string answer =
        sheet ? fmt::format("sheet_answer(f, g, d, {}, side_{}, now_{}, {})", bounds, i, i, i)
              : fmt::format("formula_answer(f, g, d, {}, {})", bounds, i);
    if (sheet) code.out.code += fmt::format("real side_{0} = 0.0, now_{0} = 0.0;\n", i);
    if (grid) answer = "answer_in_brick(" + answer + ", brick)";
    if (write_jumps(code, i)) answer = fmt::format("answer_cell({}, jump_{}(p, d))", answer, i);
    code.out.code += fmt::format(
        "Answer leaf_{0}(real3 p, real3 d) {{\n"
        "    real3 g;\n"
        "{2}"
        "    real f = value_{0}(p, g{3});\n"
        "{4}"
        "    return {1};\n"
        "}}\n",
        i, answer, second_order ? "    real m;\n" : "", second_order ? ", m" : "",
        grid ? fmt::format("    Brick brick = brick_at({}, p, d);\n", *grid) : "");
    code.needs(sheet ? "leaf/sheet.glsl" : "leaf/formula.glsl");
}

}  // namespace

void write_leaves(FieldCode& code) {
    for (std::size_t i = 0; i < code.plan.objects.size(); ++i) {
        if (code.plan.objects[i].is_member) continue;
        if (const auto* iteration = code.iteration(i)) {
            write_iteration(code, i, *iteration);
        } else if (code.is_distance(i)) {
            write_distance(code, i, *code.formula(i));
        } else if (code.along.contains(i)) {
            write_value_and_gradient(code, i, *code.formula(i));
            write_polynomial(code, i);
            code.out.polynomials.insert(i);
        } else {
            write_scalar(code, i, *code.formula(i));
        }
    }
}

}  // namespace shader
