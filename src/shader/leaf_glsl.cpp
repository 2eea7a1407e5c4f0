// SPDX-License-Identifier: MIT
// The functions of leaves.
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
}

/// Value and gradient in one function.
void write_value_and_gradient(FieldCode& code, std::size_t i, const field::Formula& leaf) {
    ExpressionWriter w = code.writer();
    const Gradient& g = code.gradients.at(code.plan.objects[i].id);
    const std::array roots{leaf.value, g[0], g[1], g[2]};
    code.out.code += fmt::format("real value_{}(real3 p, out real3 g) {{\n", i);
    code.out.code += w.statements(roots, "    ");
    code.out.code +=
        fmt::format("    g = real3({}, {}, {});\n    return {};\n}}\n", w.spelling(roots[1]),
                    w.spelling(roots[2]), w.spelling(roots[3]), w.spelling(roots[0]));
    code.finish(w);
}

void write_distance(FieldCode& code, std::size_t i, const field::Formula& leaf) {
    ExpressionWriter w = code.writer();
    code.out.code += fmt::format("real distance_{}(real3 p) {{\n", i);
    code.out.code += w.statements(std::array{leaf.value}, "    ");
    code.out.code += fmt::format("    return {};\n}}\n", w.spelling(leaf.value));
    code.finish(w);
    write_value_and_gradient(code, i, leaf);
    code.out.code += fmt::format(
        "Answer leaf_{0}(real3 p, real3 d) {{ return distance_answer(distance_{0}(p), {0}); "
        "}}\n",
        i);
    code.needs("leaf/distance.glsl");
}

void write_scalar(FieldCode& code, std::size_t i, const field::Formula& leaf) {
    write_value_and_gradient(code, i, leaf);
    // One after the other: the order of arguments is the compiler's choice.
    const std::string lipschitz = bound(code, FieldValue::What::inverse_lipschitz, i);
    const std::string second = bound(code, FieldValue::What::second_derivative, i);
    const std::string first = bound(code, FieldValue::What::first_order, i);
    const std::string bounds = fmt::format("real3({}, {}, {})", lipschitz, second, first);
    const bool sheet = leaf.kind == field::Kind::sheet;
    const std::string answer =
        sheet ? fmt::format("sheet_answer(f, g, d, {}, side_{}, now_{}, {})", bounds, i, i, i)
              : fmt::format("formula_answer(f, g, d, {}, {})", bounds, i);
    if (sheet) code.out.code += fmt::format("real side_{0} = 0.0, now_{0} = 0.0;\n", i);
    code.out.code += fmt::format(
        "Answer leaf_{0}(real3 p, real3 d) {{\n"
        "    real3 g;\n"
        "    real f = value_{0}(p, g);\n"
        "    return {1};\n"
        "}}\n",
        i, answer);
    code.needs(sheet ? "leaf/sheet.glsl" : "leaf/formula.glsl");
}

}  // namespace

void write_leaves(FieldCode& code) {
    for (std::size_t i = 0; i < code.plan.objects.size(); ++i) {
        if (const auto* iteration = code.iteration(i)) {
            write_iteration(code, i, *iteration);
        } else if (code.formula(i)->metric == field::Metric::distance && !code.is_sheet(i)) {
            write_distance(code, i, *code.formula(i));
        } else {
            write_scalar(code, i, *code.formula(i));
        }
    }
}

}  // namespace shader
