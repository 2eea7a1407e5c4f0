// SPDX-License-Identifier: MIT
// What is right: for each pixel of a picture the first surface along its ray, as far as that could
// be settled in double precision.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace oracle {

enum class Verdict : std::uint8_t {
    miss,       ///< the ray meets nothing within the bounds
    hit,        ///< there is a surface between `near` and `far`, and none before `near`
    undecided,  ///< nothing before `near`; what is between `near` and `far` could not be settled
};

/// Depths are distances from the eye along the unit ray, in world units.
struct Pixel {
    Verdict verdict = Verdict::undecided;
    /// The verdict, the object or the depth (by more than half a pixel's footprint) is another one
    /// within 0.03 pixel: too close to an outline to hold a tracer to it. Heuristic: some rays
    /// beside the pixel's own are looked at.
    bool fragile = false;
    std::int32_t object = -1;  ///< the leaf that is hit, counted from left to right; -1: none
    double near = 0;           ///< +infinity for a miss
    double far = 0;            ///< likewise
    /// Unit, facing the eye; of an undecided pixel there at its best estimate. 0 for a miss.
    glm::dvec3 normal{0};
    bool estimated = false;  ///< the verdict rests on distance estimates: heuristic

    /// The best estimate there is; +infinity for a miss.
    double depth() const { return far > near ? near + 0.5 * (far - near) : near; }
};

struct Reference {
    int width = 0;
    int height = 0;
    double pixel_width = 0;  ///< a pixel's footprint at distance 1: 2 tan(fov / 2) / full height
    /// True if a verdict rests on distance estimates, stepped with a quarter of them.
    bool heuristic = false;
    std::vector<Pixel> pixels;  ///< row by row from the top left

    const Pixel& at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

}  // namespace oracle
