// SPDX-License-Identifier: MIT
// Leaves that are polynomials along the ray: coefficients once before it, then steps by Taylor's
// formula. Everything is straight-line code over named numbers, which stay in registers.
#include <fmt/format.h>

#include "shader/field_code.h"

namespace shader {
namespace {

/// Coefficients of s, as functions of the ray, divided by the sum of their sizes.
void write_coefficients(FieldCode& code, std::size_t i) {
    const std::vector<graph::NodeId>& along = code.along.at(i);
    ExpressionWriter w = code.writer();
    for (std::size_t k = 0; k < 6; ++k) {
        w.name(code.ray[k], fmt::format("{}.{}", k < 3 ? "c" : "e", "xyz"[k % 3]));
    }
    std::string declarations, assignments;
    for (std::size_t k = 0; k < along.size(); ++k) {
        declarations += fmt::format("{}a{}_{} = 0.0", k > 0 ? ", " : "real ", i, k);
    }
    const std::string statements = w.statements(along, "    ");
    std::string size;
    for (std::size_t k = 0; k < along.size(); ++k) {
        size += fmt::format("{}abs({})", k > 0 ? " + " : "", w.spelling(along[k]));
        assignments += fmt::format("    a{}_{} = scale * {};\n", i, k, w.spelling(along[k]));
    }
    declarations += fmt::format(", scale_{} = 1.0", i);
    assignments =
        fmt::format("    real scale = 1.0 / ({});\n    scale_{} = scale;\n", size, i) + assignments;
    code.out.code += fmt::format("{};\nvoid coefficients_{}(real3 c, real3 e) {{\n{}{}}}\n",
                                 declarations, i, statements, assignments);
    code.finish(w);
}

/// The coefficients b0, b1, ... about s: Horner's scheme, again and again (Shaw and Traub 1974).
std::string shifted(std::size_t i, std::size_t degree) {
    std::string text;
    for (std::size_t k = 0; k <= degree; ++k) {
        text += fmt::format("{}b{} = a{}_{}", k > 0 ? ", " : "    real ", k, i, k);
    }
    text += ";\n";
    for (std::size_t first = 0; first < degree; ++first) {
        for (std::size_t k = degree; k-- > first;) {
            text += fmt::format("    b{} += s * b{};\n", k, k + 1);
        }
    }
    return text;
}

std::size_t binomial(std::size_t n, std::size_t k) {
    std::size_t result = 1;
    for (std::size_t i = 0; i < k; ++i) {
        result = result * (n - i) / (i + 1);
    }
    return result;
}

/// By how much |f| falls at most through the power k, for each k > 1: what b_k may be off by, and
/// its part that points at the root.
std::string falls(std::size_t degree) {
    std::string text;
    for (std::size_t k = 2; k <= degree; ++k) {
        const std::string least = k == 2 ? "" : "max(";
        text += fmt::format("    real c{} = {}{}.0 * zs_polynomial_error - sign * b{}{};\n", k,
                            least, binomial(degree, k), k, k == 2 ? "" : ", 0.0)");
    }
    return text;
}

/// The bend of a parabola that stays below |f| as far as r: of each term with the power k > 2 that
/// makes |f| smaller, r^(k - 2) is at most that at the end.
std::string bend(std::size_t degree, const std::string& r) {
    if (degree < 3) return "c2";
    std::string text = fmt::format("c{}", degree);
    for (std::size_t k = degree; k-- > 3;) text = fmt::format("(c{} + {} * {})", k, r, text);
    return fmt::format("c2 + {} * {}", r, text);
}

/// How far from s no root is, in s: `way`. The best of three parabolas that do not wait for each
/// other.
std::string certified_way(std::size_t degree) {
    const auto as_far_as = [&](const std::string& r) {
        return fmt::format("min(parabola_root(v, w, {}), {})", bend(degree, r), r);
    };
    return fmt::format(
        "    real part = 0.3 * rest, near = min(2.0 * v / abs(w), part);\n"
        "    real way = {};\n"
        "    way = max(way, {});\n"
        "    way = max(way, {});\n"
        "    if (way >= rest) way = zs_far;\n",
        as_far_as("near"), as_far_as("part"), as_far_as("rest"));
}

}  // namespace

void write_polynomial(FieldCode& code, std::size_t i) {
    const std::size_t degree = code.along.at(i).size() - 1;
    write_coefficients(code, i);
    const bool sheet = code.is_sheet(i);
    if (sheet) code.out.code += fmt::format("real side_{0} = 0.0, now_{0} = 0.0;\n", i);
    // Not a number is not greater.
    code.out.code += fmt::format(
        "Answer leaf_{0}(real s, real3 p, real3 d) {{\n{1}"
        "    bool rounded = !(abs(b0) > 4.0 * zs_polynomial_error), asks = rounded || zs_aside;\n"
        "    real sign = b0 < 0.0 ? -1.0 : 1.0, rest = 1.0 - s;\n"
        "    real v = abs(b0) - zs_polynomial_error, w = sign * b1;\n"
        "    real f = b0, rate = 0.0;\n"
        "    real3 g = real3(0.0);\n"
        "    if (asks) {{\n"
        "        f = value_{0}(p, g);\n"
        "        rate = dot(g, d);\n"
        "    }}\n"
        "    if (rounded) {{\n"
        "        sign = f < 0.0 ? -1.0 : 1.0;\n"
        "        v = scale_{0} * abs(f);\n"
        "        w = sign * scale_{0} * zs_half * rate;\n"
        "    }}\n"
        "{2}"
        "    if (rounded) c2 = max(c2, 0.0);\n"
        "{3}"
        "    way = free_way(way, v, b0);\n"
        "    real turn = {4};\n"
        "    Answer a = asks ? aside_answer(turn * f, g, turn * rate, way, {0})\n"
        "                    : polynomial_answer(turn * f, turn * b1, b2, way, {0});\n"
        "    return {5};\n}}\n",
        i, shifted(i, degree), falls(degree), certified_way(degree),
        sheet ? fmt::format("sheet_turn(f, side_{0}, now_{0})", i) : "1.0",
        sheet ? "answer_sheet(a, turn)" : "a");
    if (sheet) code.needs("leaf/sheet.glsl");
    code.needs("leaf/polynomial.glsl");
}

}  // namespace shader
