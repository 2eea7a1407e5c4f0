// SPDX-License-Identifier: MIT
// Formulas that together use every part of the generator, and programs made of them.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>

#include "compile/compile.h"
#include "shader/program_source.h"

namespace shader {

inline constexpr std::array formulas{
    "x^2 + y^2 + z^2 = 1",
    "param a = 0.5 in [0, 1]\nsin(a*x)*cos(y) + sin(y)*cos(z + t) + sin(z)*cos(x) <= a/2",
    "tan(x) + asin(y/4) + acos(z/4) + atan(x) + atan2(y, x) = 1",
    "sinh(x) + cosh(y) + tanh(z) + exp(x) + log(y + 3) + sqrt(z + 3) + cbrt(x) = 4",
    "abs(x) + sign(y) + floor(z) + ceil(x) + min(x, y, z) + max(x, y) + mod(x, 2) = 0",
    "step(0, x) + smoothstep(0, 1, y) + mix(x, y, z) + clamp(x, -1, 1) + x^2.5 + 2^y = 3",
    "hypot(x, y) + hypot(x, y, z) + r = 2",
    "param k = 0.3 in [0, 1]\nsmooth_union(sphere(1), translate(box(0.5), (1, k, 0)), k)",
    "smooth_union(menger(3), torus(1, 0.3), 0.2)",
    "displace(shell(julia() | box() \\ x <= 0, 0.1), 0.1 sin(x)) | twist(menger(1), z)",
    "param a = 1\nif(a > 0, x*y = z, repeat(z = x^2 | sphere(0.5), (2, a, 0)))",
    "offset(repeat_polar(if(t > 1, menger(1), x^2 <= 1), 5), 0.1) & repeat(julia(), (3, 3, 3))",
    "colour(repeat(repeat_polar(box(0.1), 3) | julia(), (3, 3, 3), count = (2, 2, 2)), x)",
    "param p = 8 in [2, 12]\nmandelbulb(p) | box(0.5)",
    "scale(julia(), 1.5) \\ plane(0, 0, 1, 0.2)",
    "(x*y = z) & sphere(1.5)",
    "(x^2 + y^2 <= 1) & box(2) \\ cylinder(0.4, 3) | capsule() | cone()",
    "1e-300*x + 1e300*y = 1e-45",
};

inline field::Field field_of(std::string_view text) {
    const auto formula = compile::compile_formula(text);
    if (!formula) {
        ADD_FAILURE() << text << ": " << formula.problems()[0].message;
        return field_of("sphere(1)");
    }
    return formula->field;
}

inline bool has(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

}  // namespace shader
