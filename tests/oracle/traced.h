// SPDX-License-Identifier: MIT
// References of formulas.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "compile/compile.h"
#include "oracle/trace.h"

namespace oracle {

/// What is traced; nothing else of a document matters.
struct Scene {
    std::string formula;
    scene::Bounds bounds{};
    scene::Camera camera{{2, 1.6, 3.2}, {0, 0, 0}, {0, 1, 0}, 45};
    int width = 24;
    int height = 18;

    scene::Document document() const {
        scene::Document document;
        document.formula = formula;
        document.bounds = bounds;
        document.camera = camera;
        return document;
    }
};

inline compile::Formula understood(const std::string& text) {
    auto formula = compile::compile_formula(text);
    if (!formula) {
        ADD_FAILURE() << text << ": " << formula.problems().front().message;
        return understood("sphere(1)");
    }
    return std::move(*formula);
}

inline Reference traced(const Scene& scene, int threads = 1) {
    const Query query{.width = scene.width,
                      .height = scene.height,
                      .region = {},
                      .threads = threads,
                      .progress = {}};
    auto reference = trace(understood(scene.formula), scene.document(), query);
    if (!reference) {
        ADD_FAILURE() << scene.formula << ": " << reference.problems().front().message;
        return {};
    }
    return std::move(*reference);
}

/// What the ray along -z from (x, y, 5) meets.
inline Pixel down_z(const std::string& formula, double x = 0, double y = 0,
                    const scene::Bounds& bounds = {}) {
    Scene scene{.formula = formula, .bounds = bounds};
    scene.camera = {{x, y, 5}, {x, y, 0}, {0, 1, 0}, 10};
    scene.width = scene.height = 1;
    return traced(scene).at(0, 0);
}

}  // namespace oracle
