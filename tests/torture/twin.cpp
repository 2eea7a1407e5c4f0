// SPDX-License-Identifier: MIT
#include "torture/twin.h"

#include <map>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace torture {
namespace {

/// A union of strips, each a plane between two walls; {0} stands for the strip's number.
std::string strips(fmt::format_string<int&, int> strip, int first, int last) {
    std::string text;
    for (int k = first; k <= last; ++k) {
        text += (text.empty() ? "" : " | ") + fmt::format(strip, k, k + 1);
    }
    return text;
}

const std::map<std::string, std::string>& table() {
    static const std::map<std::string, std::string> formulas{
        {"even_roots/cosine_touches", "sin(2x + y + z/2) = 0"},
        {"even_roots/torus_to_the_fourth", "(x^2 + y^2 + z^2 + 0.8)^2 - 4(x^2 + y^2) = 0"},
        {"jumps/sawtooth", strips("y = (3x - {0})/2 & x >= {0}/3 & x <= {1}/3", -5, 4)},
        {"jumps/stairs", strips("z = {0}/4 & x >= {0}/4 & x <= {1}/4", -6, 5)},
        {"poles/quotient", "x^2 + y^2 + z^2 = 1"},
        {"poles/tangent", "y*cos(3x) = sin(3x)"},
        {"walls/fins", "cos(20pi*x) <= -cos(pi/5) & sphere(1)"},
    };
    return formulas;
}

}  // namespace

std::optional<Scene> twin_of(const Scene& scene) {
    const auto found = table().find(scene.name);
    if (found == table().end()) return std::nullopt;
    Scene twin;
    twin.name = scene.name + "'s twin";
    twin.document = scene.document;
    twin.document.formula = found->second;
    auto formula = compile::compile_formula(found->second);
    if (!formula) {
        ADD_FAILURE() << twin.name << ": " << text_of(formula.problems());
        return std::nullopt;
    }
    twin.formula = std::move(*formula);
    return twin;
}

}  // namespace torture
