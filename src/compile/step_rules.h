// SPDX-License-Identifier: MIT
// By what right rays are as fast as they are: how the steps at each object are found, and why so.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "compile/compile.h"

namespace compile {

/// Of one leaf, or of all leaves below a blend.
struct StepRule {
    enum class By {
        distance,           ///< its value, which is a bound of the distance
        second_derivative,  ///< value and slope with the bound M, or by L where that is longer
        lipschitz,          ///< its value over L
        polynomial,         ///< value and derivatives of the polynomial that it is along the ray,
                            ///< whose coefficients are rounded by an error that is estimated
        bricks,             ///< by L and M of the brick where the ray is
        intervals,          ///< what they prove of parts of the ray
        estimate,           ///< the distance estimate of an iteration: heuristic
        first_order,        ///< |f| / |grad f|, or a proven step where that is longer: heuristic
        blind,              ///< parts of the region: heuristic
        tracer,             ///< what the tracer that was chosen does: heuristic
    };
    /// Why nothing better is proven, or why what is proven is not gone by.
    enum class Doubt {
        none,
        estimate,   ///< of escape-time sets and other iterations
        undefined,  ///< a pole or an edge of a domain may be in the region
        jumps,      ///< so may a jump
        unbounded,  ///< no bound of the derivatives was found
        endless,    ///< there are no bounds of the region
        stiff,      ///< proven steps would be too many
        chosen,     ///< by the choice of the tracer
    };

    std::size_t first_object = 0;  ///< counted from left to right
    std::size_t objects = 1;
    By by = By::distance;
    Doubt doubt = Doubt::none;
    double lipschitz = std::numeric_limits<double>::infinity();          ///< L, if it is known
    double second_derivative = std::numeric_limits<double>::infinity();  ///< M, likewise
    std::size_t bricks = 0;    ///< in which a surface may be, of one that is known brick by brick
    std::size_t doubtful = 0;  ///< those of them where steps are guesses

    bool proven() const { return doubt == Doubt::none; }
    bool within_rounding() const { return by == By::polynomial; }
};

/// What the program does with these numbers. Costs next to nothing.
std::vector<StepRule> step_rules(const field::Field& field, const shader::ProgramSource& source,
                                 const shader::FieldNumbers& numbers,
                                 const scene::Document& document);

/// "certified by the distance", "by the first order: a pole or the edge of a domain".
std::string describe(const StepRule& rule);

/// All in a few words: "certified", "certified within rounding", "2 of 3 certified; stiff".
std::string summary(std::span<const StepRule> rules);

}  // namespace compile
