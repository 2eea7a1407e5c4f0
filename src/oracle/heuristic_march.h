// SPDX-License-Identifier: MIT
// The reference for escape-time sets: their own distance estimates, in small steps.
#pragma once

#include <vector>

#include "oracle/first_hit.h"
#include "oracle/heuristic_distance.h"

namespace oracle {

/// Goes along a ray by a quarter of the estimated distance until that is below a thousandth of a
/// pixel's footprint, or inside; then brackets the surface where there is an inside close ahead.
/// Nothing is proven: estimates may be too large. Not for several threads.
class HeuristicMarch {
public:
    explicit HeuristicMarch(const Shape& shape);

    /// Of all parts that are estimated, or of all with loops, within the stretch. `pixel_width` is
    /// at distance 1.
    enum class Of { estimated, loops };
    Found operator()(const Ray& ray, const Stretch& stretch, double pixel_width, Of of);

private:
    using RayNumber = numeric::SecondOrder<double, 1>;

    Found march(std::size_t part, const Ray& ray, const Stretch& stretch, double pixel_width);
    /// The way to the nearest wall of a cell ahead.
    double way_to_walls(const Part& part, const Ray& ray, double t);
    void enclose(Found& found, std::size_t solid, const Ray& ray, double distance);
    void bisect(Found& found, std::size_t solid, const Ray& ray);

    const Shape& shape_;
    HeuristicDistance distance_;
    Values<RayNumber> slopes_;
};

}  // namespace oracle
