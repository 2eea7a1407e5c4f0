// SPDX-License-Identifier: MIT
#include "render/bounds_on_screen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace render {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Of places along a row, in units of the image plane; none if first > last.
struct Span {
    double first = infinity, last = -infinity;

    void add(double x) {
        first = std::min(first, x);
        last = std::max(last, x);
    }
    void add(const Span& other) {
        first = std::min(first, other.first);
        last = std::max(last, other.last);
    }
};
constexpr Span everything{-infinity, infinity};

/// The bounds as the eye sees them: along the camera's axes.
struct Seen {
    glm::dvec3 centre, half;
    glm::dvec3 right, up, forward;

    glm::dvec3 along_axes(glm::dvec3 p) const {
        return {glm::dot(p, right), glm::dot(p, up), glm::dot(p, forward)};
    }
};

/// Where rays through the places (x, y, 1) meet a sphere: the angle to its middle is small enough.
Span of_sphere(const Seen& seen, double y) {
    const glm::dvec3 c = seen.along_axes(seen.centre);
    const double q = glm::dot(c, c) - seen.half.x * seen.half.x;
    // The square of (d, c) is at least q |d|^2: a x^2 + 2 b x + e >= 0.
    const double rest = c.y * y + c.z;
    const double a = c.x * c.x - q, b = c.x * rest, e = rest * rest - q * (y * y + 1);
    if (q <= 0 || !(a < 0)) return everything;
    const double square = b * b - a * e;
    if (square < 0) return {};
    const double root = std::sqrt(square);
    const Span span{(b - root) / -a, (b + root) / -a};
    const bool ahead = c.x * (span.first + span.last) / 2 + rest > 0;
    return ahead ? span : Span{};
}

/// Where they meet a box: within the lines from corner to corner.
Span of_box(const Seen& seen, double y) {
    std::array<glm::dvec3, 8> corners;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 sides((i & 1) * 2 - 1, (i & 2) - 1, (i & 4) / 2 - 1);
        corners[static_cast<std::size_t>(i)] = seen.along_axes(seen.centre + sides * seen.half);
    }
    Span span;
    for (glm::dvec3& p : corners) {
        if (!(p.z > 1e-3 * glm::length(seen.half))) return everything;
        p /= p.z;
    }
    for (const glm::dvec3& p : corners) {
        for (const glm::dvec3& q : corners) {
            if (p.y > y || q.y < y) continue;
            span.add(q.y > p.y ? p.x + (q.x - p.x) * (y - p.y) / (q.y - p.y) : p.x);
        }
    }
    return span;
}

}  // namespace

ScreenParts bounds_on_screen(const Frame& frame, bool box, const Tile& tile) {
    constexpr int margin = 2;
    const Seen seen{glm::dvec3(frame.bounds_centre) - glm::dvec3(frame.eye),
                    glm::dvec3(frame.bounds_half), glm::dvec3(frame.right), glm::dvec3(frame.up),
                    glm::dvec3(frame.forward)};
    const double unit = frame.eye.w / frame.picture.y;
    const auto row = [&](int j) {
        const double place = std::floor((j + 0.5) * frame.passes.z) + frame.picture.w + 0.5;
        const double y = unit * (frame.picture.y - 2 * place);
        return box ? of_box(seen, y) : of_sphere(seen, y);
    };
    const auto column = [&](double x) {
        const double place = (x / unit + frame.picture.x) / 2;
        const double i = (place - frame.picture.z - 0.5) / frame.passes.y;
        return std::clamp(i, tile.x - 1e3, tile.x + tile.width + 1e3);
    };
    ScreenParts parts;
    const auto add = [](std::vector<Tile>& list, Tile part) {
        if (part.width > 0 && part.height > 0) list.push_back(part);
    };
    const int step = std::max(16, (tile.height + 7) / 8);
    for (int y = tile.y; y < tile.y + tile.height; y += step) {
        const int end = std::min(y + step, tile.y + tile.height);
        Span span;
        for (int j = y - margin; j < end + margin; ++j) span.add(row(j));
        int first = tile.x, last = tile.x;
        if (span.first <= span.last) {
            first = static_cast<int>(std::floor(column(span.first))) - margin;
            last = static_cast<int>(std::ceil(column(span.last))) + 1 + margin;
        }
        first = std::clamp(first, tile.x, tile.x + tile.width);
        last = std::clamp(last, first, tile.x + tile.width);
        add(parts.inside, {first, y, last - first, end - y});
        add(parts.outside, {tile.x, y, first - tile.x, end - y});
        add(parts.outside, {last, y, tile.x + tile.width - last, end - y});
    }
    return parts;
}

}  // namespace render
