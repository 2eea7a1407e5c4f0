// SPDX-License-Identifier: MIT
// How far a rendered picture agrees with the known answer.
#pragma once

#include <iosfwd>
#include <string>
#include <variant>

#include "render_answers/exact_shape.h"
#include "render_answers/shot.h"

namespace render_answers {

/// A formula and the shape that it is, to be seen inside of the query's bounds.
struct Answer {
    std::string name;
    Query query;
    std::variant<Solid, Sheet> shape;
};

std::ostream& operator<<(std::ostream& stream, const Answer& answer);

/// Pixels, except for those that a silhouette passes through: of the shape, of a part of it in
/// front of another, or hidden. Where two parts meet in a pixel any depth between theirs is right.
struct Agreement {
    int compared = 0;
    int missed = 0;      ///< there is a surface, and none was found
    int phantom = 0;     ///< there is none, and one was found
    int off_depth = 0;   ///< the relative error of the depth is above 1e-5
    int off_normal = 0;  ///< not of unit length, not facing the eye, or 2e-3 radians or more away
    int unresolved = 0;  ///< the tracer gave up
    double depth_error = 0;   ///< the largest relative one
    double normal_error = 0;  ///< the largest angle in radians
    std::string examples;     ///< the first few wrong pixels, in words

    int wrong() const { return missed + phantom + off_depth + off_normal + unresolved; }
};

std::ostream& operator<<(std::ostream& stream, const Agreement& agreement);

Agreement compare(const Answer& answer);
/// A still that is there already: of the answer's query.
Agreement compare(const Answer& answer, const render::Still& still);

}  // namespace render_answers
