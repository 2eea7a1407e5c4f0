// SPDX-License-Identifier: MIT
// How wrong a picture is. The one definition for the command line, tests, benchmarks and the
// studio.
#pragma once

#include <cstdint>
#include <vector>

#include "base/result.h"
#include "image/image.h"
#include "oracle/reference.h"

namespace oracle {

/// What a tracer made, of the size of the reference. An empty `normal` or `gave_up` is not
/// compared.
struct Shot {
    image::Grey depth;          ///< along the unit ray in world units; +infinity for a miss
    image::Vectors normal;      ///< unit, facing the eye; 0 for a miss
    std::vector<bool> gave_up;  ///< pixels that the tracer itself calls unresolved
};

enum class Judgement : std::uint8_t {
    right,
    missed,   ///< there is a surface, and none was found
    phantom,  ///< a surface was found where there is none
    /// found, but in depth more than half a pixel's footprint away: the footprint at the
    /// reference's depth, so where that is 0 (an eye inside of a solid) nothing but 0 is right
    moved,
    excused,  ///< undecided, or fragile: not held against anyone
};

/// Of a set of errors; 0 of none. Percentiles are members of the set: the smallest that is at least
/// as large as so many of it.
struct Spread {
    double median = 0;
    double percentile_99 = 0;
    double largest = 0;
};

struct Metrics {
    std::size_t compared = 0;  ///< pixels that are not excused
    std::size_t undecided = 0;
    std::size_t fragile = 0;  ///< and not undecided
    std::size_t missed = 0;
    std::size_t phantom = 0;
    std::size_t moved = 0;
    /// Of the missed and phantoms, those whose depth is NaN or negative, which no depth is.
    std::size_t no_depth = 0;
    std::size_t gave_up = 0;  ///< among the compared; they are judged by what they show as well
    Spread depth_error;       ///< relative, of the pixels where both hit and that are right
    /// Degrees, of the same pixels where the reference has a normal. A normal that is 0 or NaN is
    /// 180 degrees off.
    Spread normal_error;
    std::vector<Judgement> judgements;  ///< one a pixel

    std::size_t wrong() const { return missed + phantom + moved; }
};

/// Judges every pixel. Errors: sizes that differ.
base::Result<Metrics> compare(const Reference& reference, const Shot& shot);

/// A colour has changed visibly if a channel differs by more than this, in steps of 8-bit sRGB: the
/// tolerance for image::compare wherever two shaded pictures are compared.
inline constexpr int visible_colour_difference = 8;

}  // namespace oracle
