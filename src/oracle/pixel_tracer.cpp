// SPDX-License-Identifier: MIT
#include "oracle/pixel_tracer.h"

#include <algorithm>

namespace oracle {

PixelTracer::PixelTracer(const Shape& shape, const scene::Bounds& bounds, const Pinhole& pinhole)
    : bounds_(bounds),
      pinhole_(pinhole),
      first_hit_(shape),
      march_(shape),
      surface_(shape, bounds),
      is_heuristic_(is_heuristic(shape)) {}

Beam PixelTracer::beam(const Tile& tile) const {
    const auto side = [](int begin, int size) {
        return numeric::Interval(begin, static_cast<double>(begin) + size);
    };
    return pinhole_.through(side(tile.x, tile.width), side(tile.y, tile.height));
}

Places PixelTracer::places(const Tile& tile) {
    return places(tile, first_hit_.anywhere(within(bounds_, beam(tile))));
}

Places PixelTracer::places(const Tile& tile, const Places& around) {
    const Beam rays = beam(tile);
    return first_hit_.narrowed(rays, around, latest_begin(bounds_, rays));
}

Pixel PixelTracer::operator()(double x, double y, const Places& places) {
    const Ray ray = pinhole_.through(x, y);
    const std::optional<Stretch> stretch = within(bounds_, ray);
    if (!stretch) return seen(ray, {}, is_heuristic_);
    const Found found = first_hit_(ray, *stretch, places);
    if (found.verdict == Verdict::undecided && first_hit_.proves_loops()) {
        // What cannot be proven of iterations is estimated; before it nothing is.
        return seen(ray, estimated(ray, *stretch, found.near, places), true);
    }
    const Stretch rest{stretch->begin, std::min(stretch->end, found.far)};
    if (!(rest.begin < rest.end)) return seen(ray, found, is_heuristic_);
    const Found marched = march_(ray, rest, pinhole_.pixel_width(), HeuristicMarch::Of::estimated);
    return seen(ray, nearer(found, marched), is_heuristic_);
}

Pixel PixelTracer::estimated(double x, double y, const Places& places) {
    if (!first_hit_.proves_loops()) return (*this)(x, y, places);
    const Ray ray = pinhole_.through(x, y);
    const std::optional<Stretch> stretch = within(bounds_, ray);
    return seen(ray, stretch ? estimated(ray, *stretch, stretch->begin, places) : Found{}, true);
}

/// Iterations from `begin` on, all else on the whole stretch.
Found PixelTracer::estimated(const Ray& ray, const Stretch& stretch, double begin,
                             const Places& places) {
    const Found found = first_hit_(ray, stretch, places, FirstHit::Of::formulas);
    const Stretch rest{begin, std::min(stretch.end, found.far)};
    if (!(rest.begin < rest.end)) return found;
    return nearer(found, march_(ray, rest, pinhole_.pixel_width(), HeuristicMarch::Of::loops));
}

Pixel PixelTracer::seen(const Ray& ray, const Found& found, bool estimated) {
    Pixel pixel{
        .verdict = found.verdict, .near = found.near, .far = found.far, .estimated = estimated};
    if (found.verdict == Verdict::miss) return pixel;
    const Surface surface = surface_(ray, found, pinhole_.pixel_width() * found.middle());
    pixel.object = surface.object;
    pixel.normal = surface.normal;
    return pixel;
}

}  // namespace oracle
