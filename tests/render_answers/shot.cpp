// SPDX-License-Identifier: MIT
#include "render_answers/shot.h"
#include "headless.h"

#include <gtest/gtest.h>

#include "compile/compile.h"

namespace render_answers {

scene::Bounds sphere_bounds(double radius, glm::dvec3 centre) {
    return {scene::Bounds::Shape::sphere, centre, glm::dvec3(radius)};
}

scene::Bounds box_bounds(glm::dvec3 half, glm::dvec3 centre) {
    return {scene::Bounds::Shape::box, centre, half};
}

scene::Bounds no_bounds() { return {scene::Bounds::Shape::none, glm::dvec3(0), glm::dvec3(2)}; }

scene::Camera camera(glm::dvec3 eye, glm::dvec3 target, double fov, glm::dvec3 up) {
    return {eye, target, up, fov};
}

scene::Document document_of(const Query& query) {
    scene::Document document;
    document.formula = query.formula;
    document.bounds = query.bounds;
    document.camera = query.camera;
    document.settings = query.settings;
    return document;
}

render::Still render(const scene::Document& document, const render::View& view,
                     const shader::Outputs& outputs) {
    const auto problems = [](const base::Diagnostics& list) {
        std::string text;
        for (const base::Diagnostic& problem : list) text += problem.message + '\n';
        return text;
    };
    const auto formula = compile::compile_formula(document.formula);
    if (!formula) {
        ADD_FAILURE() << document.formula << ": " << problems(formula.problems());
        return {};
    }
    auto context = open_headless();
    if (!context) {
        ADD_FAILURE() << problems(context.problems());
        return {};
    }
    const shader::ProgramSource source = compile::program_source(*formula, document, outputs);
    const shader::FieldNumbers numbers = compile::field_numbers(*formula, source, document);
    const double aspect = static_cast<double>(view.width) / view.height;
    const scene::Camera camera = scene::camera_of(document, aspect);
    const auto frame_of = [&](const render::View& part) {
        return render::frame(document, camera, part);
    };
    auto still = render::draw_still(**context, source, numbers, frame_of, view, outputs);
    if (!still) {
        ADD_FAILURE() << document.formula << ": " << problems(still.problems());
        return {};
    }
    return std::move(*still);
}

render::Still render(const Query& query) {
    return render(document_of(query), render::whole(query.width, query.height));
}

double depth(const render::Still& still, int i, int j) { return still.geometry.at(i, j)[0]; }

shader::Status status(const render::Still& still, int i, int j) {
    return static_cast<shader::Status>(still.geometry.at(i, j)[2]);
}

glm::dvec3 normal(const render::Still& still, int i, int j) {
    const float* n = still.normal.at(i, j);
    return {n[0], n[1], n[2]};
}

int count(const render::Still& still, shader::Status wanted) {
    int number = 0;
    for (int j = 0; j < still.geometry.height; ++j) {
        for (int i = 0; i < still.geometry.width; ++i) number += status(still, i, j) == wanted;
    }
    return number;
}

}  // namespace render_answers
