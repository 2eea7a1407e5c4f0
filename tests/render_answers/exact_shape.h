// SPDX-License-Identifier: MIT
// Shapes made of polynomial parts, intersected with rays in double precision: the known answers.
#pragma once

#include <functional>
#include <vector>

#include "render_answers/polynomial.h"
#include "render_answers/ray.h"
#include "scene/camera.h"

namespace render_answers {

/// A function of the point; along a ray each coordinate is a polynomial of degree 1.
using Function =
    std::function<Polynomial(const Polynomial& x, const Polynomial& y, const Polynomial& z)>;

/// Where a ray passes through a surface; the normal is not unit, and of either sign.
struct Crossing {
    double t = 0;
    glm::dvec3 normal{0};
    const void* part = nullptr;  ///< tells the functions of one shape apart
};

/// A stretch of a ray that is inside of a solid.
struct Span {
    Crossing enter, leave;
};

/// The stretches of a ray inside of a solid, ascending and apart, over all t in (-1e4, 1e4).
using Solid = std::function<std::vector<Span>(const Ray&)>;
/// Where a ray passes through a sheet, ascending, over the same range.
using Sheet = std::function<std::vector<Crossing>(const Ray&)>;

/// Where the function is below 0.
Solid below(Function function);
Solid operator&(Solid a, Solid b);
Solid operator|(Solid a, Solid b);
Solid operator!(Solid a);
/// Nothing at all.
Solid nothing();

/// The solid a*x + b*y + c*z <= d.
Solid half_space(double a, double b, double c, double d);
Solid ball(double radius, glm::dvec3 centre = glm::dvec3(0));
Solid cuboid(glm::dvec3 half, glm::dvec3 centre = glm::dvec3(0));
/// Those of the formula language: axis z.
Solid torus(double large, double small);
Solid cylinder(double radius, double half_height);
Solid cone(double radius, double half_height);
Solid capsule(double radius, double half_height);
/// The inside of bounds; everything for none.
Solid inside(const scene::Bounds& bounds);

/// Where the function changes its sign.
Sheet zeros(Function function);
/// What of the sheet is inside of the solid.
Sheet operator&(Sheet sheet, Solid solid);
Sheet operator|(Sheet a, Sheet b);
/// The boundary of a solid.
Sheet boundary(Solid solid);

}  // namespace render_answers
