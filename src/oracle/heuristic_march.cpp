// SPDX-License-Identifier: MIT
#include "oracle/heuristic_march.h"

#include <algorithm>
#include <cmath>

namespace oracle {
namespace {

constexpr double step_part = 0.25;
constexpr double footprint_part = 1e-3;
constexpr int most_steps = 50'000;
/// Where nothing is known about the distance a step is this part of the stretch.
constexpr double blind_part = 1.0 / 512;
constexpr double enclosure = 1e-9;

/// True if all leaves below tell distances; first-order ones of other formulas may be far too
/// large.
bool tells_distances(const Shape& shape, std::size_t solid) {
    const Solid& node = shape.solids[solid];
    if (node.what == Solid::What::formula) return node.distance;
    return std::ranges::all_of(
        node.operands, [&](std::size_t operand) { return tells_distances(shape, operand); });
}

}  // namespace

HeuristicMarch::HeuristicMarch(const Shape& shape)
    : shape_(shape), distance_(shape), slopes_(shape) {}

double HeuristicMarch::way_to_walls(const Part& part, const Ray& ray, double t) {
    double way = numeric::infinity;
    if (part.walls.empty()) return way;
    const glm::dvec3 p = ray.at(t), &d = ray.direction;
    slopes_.move_to(
        {RayNumber::along(p.x, d.x), RayNumber::along(p.y, d.y), RayNumber::along(p.z, d.z)});
    for (const std::size_t wall : part.walls) {
        const RayNumber u = slopes_.expression(wall);
        if (u.has_slope(0) && u.slope(0) < 0) way = std::min(way, u.value / -u.slope(0));
    }
    return std::max(way, 0.0);
}

/// Halves the way between a point outside and one inside.
void HeuristicMarch::bisect(Found& found, std::size_t solid, const Ray& ray) {
    while (found.far - found.near > enclosure * found.far) {
        const double middle = found.middle();
        if (middle <= found.near || middle >= found.far) return;
        (distance_(solid, ray.at(middle)) <= 0 ? found.far : found.near) = middle;
    }
}

/// From a point that is closer to the surface than can be seen.
void HeuristicMarch::enclose(Found& found, std::size_t solid, const Ray& ray, double distance) {
    for (const double reach : {1.0, 2.0, 4.0, 8.0}) {
        found.far = found.near + reach * distance;
        if (distance_(solid, ray.at(found.far)) <= 0) return bisect(found, solid, ray);
    }
    // Koebe's theorem leaves a factor of 4 between the estimate and the distance.
    found.far = found.near + 4 * distance;
}

Found HeuristicMarch::march(std::size_t number, const Ray& ray, const Stretch& stretch,
                            double pixel_width) {
    const Part& part = shape_.parts[number];
    const double blind = blind_part * (stretch.end - stretch.begin);
    const double known = tells_distances(shape_, part.solid) ? field::unknown_depth : 0;
    Found found{.verdict = Verdict::hit, .number = number};
    double t = stretch.begin, distance = distance_(part.solid, ray.at(t));
    found.near = found.far = t;
    found.at_start = distance <= 0;
    if (found.at_start) return found;
    for (int step = 0; step < most_steps; ++step) {
        found.near = t;
        if (distance < footprint_part * pixel_width * t) {
            enclose(found, part.solid, ray, distance);
            return found;
        }
        const double least = 1e-12 * t + 1e-15;
        const double way = std::min({step_part * distance, way_to_walls(part, ray, t) + least,
                                     distance < known ? numeric::infinity : blind});
        t += std::max(way, least);
        if (t > stretch.end) return {};
        distance = distance_(part.solid, ray.at(t));
        if (distance <= 0) {
            found.far = t;
            bisect(found, part.solid, ray);
            return found;
        }
    }
    found.verdict = Verdict::undecided;
    found.far = std::min(stretch.end, t + 4 * distance);
    return found;
}

Found HeuristicMarch::operator()(const Ray& ray, const Stretch& stretch, double pixel_width,
                                 Of of) {
    Found found;
    for (std::size_t i = 0; i < shape_.parts.size(); ++i) {
        const Solid& solid = shape_.solids[shape_.parts[i].solid];
        if (!(of == Of::loops ? solid.has_loops : solid.estimated)) continue;
        const Stretch rest{stretch.begin, std::min(stretch.end, found.far)};
        if (rest.begin < rest.end) found = nearer(found, march(i, ray, rest, pixel_width));
    }
    return found;
}

}  // namespace oracle
