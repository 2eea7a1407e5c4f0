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

/// What a tracer made, of the size of the reference. Parts that are empty are not compared.
struct Shot {
    image::Grey depth;          ///< +infinity for a miss
    image::Vectors normal;      ///< unit, facing the eye; 0 for a miss
    std::vector<bool> gave_up;  ///< pixels that the tracer itself calls unresolved
};

enum class Judgement : std::uint8_t {
    right,
    missed,   ///< there is a surface, and none was found
    phantom,  ///< a surface was found where there is none
    moved,    ///< found, but more than half a pixel's footprint away in depth
    excused,  ///< undecided, or fragile: not held against anyone
};

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
    std::size_t gave_up = 0;  ///< among the compared; they are judged by what they show as well
    Spread depth_error;       ///< relative, where both hit and neither excused nor moved
    Spread normal_error;      ///< degrees, likewise
    std::vector<Judgement> judgements;  ///< one a pixel

    std::size_t wrong() const { return missed + phantom + moved; }
};

/// Error: sizes that differ.
base::Result<Metrics> compare(const Reference& reference, const Shot& shot);

}  // namespace oracle
