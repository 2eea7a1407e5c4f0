// SPDX-License-Identifier: MIT
#include "oracle/pixel_tracer.h"

namespace oracle {

PixelTracer::PixelTracer(const Shape& shape, const scene::Bounds& bounds, const Pinhole& pinhole)
    : bounds_(bounds),
      pinhole_(pinhole),
      first_hit_(shape),
      march_(shape),
      surface_(shape, bounds) {}

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
    Found found;
    if (const std::optional<Stretch> stretch = within(bounds_, ray)) {
        found = first_hit_(ray, *stretch, places);
        const Stretch rest{stretch->begin, std::min(stretch->end, found.far)};
        if (rest.begin < rest.end) {
            found = nearer(found, march_(ray, rest, pinhole_.pixel_width()));
        }
    }
    Pixel pixel{.verdict = found.verdict, .near = found.near, .far = found.far};
    if (found.verdict == Verdict::miss) return pixel;
    const Surface surface = surface_(ray, found, pinhole_.pixel_width() * found.middle());
    pixel.object = surface.object;
    pixel.normal = surface.normal;
    return pixel;
}

}  // namespace oracle
