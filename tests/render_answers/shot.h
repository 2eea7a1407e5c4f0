// SPDX-License-Identifier: MIT
// A formula rendered as the command line renders it, with everything that is known about its
// pixels.
#pragma once

#include <string>

#include "render/frame.h"
#include "render/still.h"
#include "scene/document.h"
#include "shader/program_source.h"

namespace render_answers {

/// A formula to render and how. Parts of a document that are not named are the defaults.
struct Query {
    std::string formula;
    scene::Bounds bounds{};
    scene::Camera camera{};
    scene::Settings settings{};
    int width = 120;
    int height = 90;
};

scene::Bounds sphere_bounds(double radius, glm::dvec3 centre = glm::dvec3(0));
scene::Bounds box_bounds(glm::dvec3 half, glm::dvec3 centre = glm::dvec3(0));
scene::Bounds no_bounds();
scene::Camera camera(glm::dvec3 eye, glm::dvec3 target = glm::dvec3(0), double fov = 45,
                     glm::dvec3 up = {0, 1, 0});

/// The document of a query.
scene::Document document_of(const Query& query);

/// What the software driver made of a document; fails the test and returns an empty still on
/// errors.
render::Still render(const scene::Document& document, const render::View& view,
                     const shader::Outputs& outputs = {
                         .picture = false, .geometry = true, .normal = true});
/// The whole picture of a query, without colours.
render::Still render(const Query& query);

/// Parts of the geometry of pixel (i, j).
double depth(const render::Still& still, int i, int j);
shader::Status status(const render::Still& still, int i, int j);
glm::dvec3 normal(const render::Still& still, int i, int j);

/// How many pixels have a status.
int count(const render::Still& still, shader::Status status);

}  // namespace render_answers
