// SPDX-License-Identifier: MIT
// The GLSL functions of a field: what tracers and shading ask of it.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "shader/program_source.h"

namespace shader {

/// What a tracer asks of formulas beyond value and gradient.
struct Demands {
    bool hessians = false;     ///< the norm of the Hessian at each point, in place of bounds
    bool intervals = false;    ///< enclosures of the tree over intervals of a ray
    bool polynomials = false;  ///< leaves that are polynomials along a ray of finite length
    bool bricks = false;       ///< bounds brick by brick, where they are known
    bool text_only = false;    ///< no families
};

/// Generated code, and what it needs.
struct FieldGlsl {
    std::string facts;  ///< constants that stand before all other parts
    std::string code;
    std::set<std::string> operator_parts;  ///< below shaders/, to stand before the code
    std::set<std::string> leaf_parts;      ///< likewise
    std::set<std::string> interval_parts;  ///< likewise, after those
    std::vector<FieldValue> values;
    std::vector<field::FieldId> bricks;  ///< that are read brick by brick, in the order of grids
    eval::Tape expressions;              ///< those among the values, in their order
    std::vector<FamilyTable> families{};
    std::vector<FamilyTree> family_trees{};
    bool needs_differences = false;  ///< for gradients
    bool has_colours = false;
    bool has_edges = false;  ///< a formula may be undefined somewhere
    /// There are iterations, and answers do not depend on the direction: `free` is the radius of a
    /// ball that holds no surface.
    bool answers_balls = false;
    /// Every answer has a derivative along the ray, which is continuous, and changes its sign at
    /// surfaces only.
    bool is_regular = false;
    std::set<std::size_t> polynomials;  ///< objects that are walked as polynomials along the ray
};

/// Writes, for the tree and each leaf (object 0, 1, ... from left to right):
///   zs_has_edges     whether a leaf may be undefined somewhere
///   zs_has_rates     whether every answer has a derivative along the ray
///   zs_knows_evenness whether every answer is a distance, or an iteration's with an evenness
///   zs_longer_steps  how many times as long as `free` a shadow ray's steps may be
///   zs_objects       how many leaves there are
///   void field_start(o, d, t0, t1)
///                    before a ray, of which only [t0, t1] will be asked for
///   Answer field(o, d, t)
///                    the answer of the whole tree at o + t d, along the unit vector d
///   void field_accept()
///                    after the ray has gone on to the point last asked for
///   void field_forget()
///                    before the ray goes on elsewhere: as if none had been asked for
///   real3 object_gradient(i, p, h)
///                    the gradient of a leaf, by differences over h if it is an iteration, or of
///                    the blend that it is part of
///   real object_distance(i, p)
///                    the value of an iteration or blend; only if there are any
///   bool object_is_zero(i, p, off)
///                    whether the value of a leaf is within its rounding error of 0 at p, whose
///                    coordinates are off by that much, or no bound of it is known; only if
///                    is_regular
///   bool object_colour(i, p, colour)
///                    a leaf's own colour, if it has one; only if some leaf has
///   Enclosure enclose(o, d, t)
///                    the whole tree over the interval t of the ray; only on demand
/// The field's graph gets the derivatives' nodes, hence the copy.
/// `bricks` are the formulas that are known brick by brick.
FieldGlsl field_glsl(field::Field field, bool count_evaluations, const Demands& demands = {},
                     std::vector<field::FieldId> bricks = {},
                     Precision precision = Precision::single);

}  // namespace shader
