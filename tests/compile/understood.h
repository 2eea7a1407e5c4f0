// SPDX-License-Identifier: MIT
// Formulas that are known to be good.
#pragma once

#include <gtest/gtest.h>

#include <string_view>

#include "compile/compile.h"

namespace compile {

inline Formula understood(std::string_view text) {
    auto formula = compile_formula(text);
    if (!formula) {
        for (const base::Diagnostic& problem : formula.problems()) {
            ADD_FAILURE() << text << ": " << problem.message;
        }
        return understood("sphere(1)");
    }
    return std::move(*formula);
}

}  // namespace compile
