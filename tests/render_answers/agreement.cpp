// SPDX-License-Identifier: MIT
#include "render_answers/agreement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace render_answers {
namespace {

constexpr double depth_tolerance = 1e-5;
constexpr double normal_tolerance = 2e-3;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// What a ray sees, and how many surfaces it passes in all.
struct Seen {
    double depth = infinity;
    glm::dvec3 normal{0};  ///< unit, facing the eye; 0 where the eye is inside
    std::size_t crossings = 0;
    const void* part = nullptr;  ///< of the shape
};

class Eye {
public:
    explicit Eye(const Answer& answer)
        : query_(answer.query), is_solid_(std::holds_alternative<Solid>(answer.shape)) {
        Solid region = inside(query_.bounds);
        if (query_.bounds.shape == scene::Bounds::Shape::none) {
            region = ball(scene::far_distance, query_.camera.eye);
        }
        if (is_solid_) {
            solid_ = std::get<Solid>(answer.shape) & region;
            sheet_ = boundary(solid_);
        } else {
            sheet_ = std::get<Sheet>(answer.shape) & region;
        }
        const int columns = 2 * query_.width + 1;
        const int rows = 2 * query_.height + 1;
        for (int b = 0; b < rows; ++b) {
            for (int a = 0; a < columns; ++a) seen_.push_back(look(a / 2.0, b / 2.0));
        }
    }

    const Seen& at_centre(int i, int j) const { return at(2 * i + 1, 2 * j + 1); }

    /// True if a silhouette passes through the pixel, as far as its corners and edges tell.
    bool at_silhouette(int i, int j) const {
        const Seen& seen = at_centre(i, j);
        return any_around(i, j, [&](const Seen& other) {
            return other.crossings != seen.crossings ||
                   std::isfinite(other.depth) != std::isfinite(seen.depth);
        });
    }

    /// True if two parts of the shape meet in the pixel, with an edge or one in front of the other.
    bool at_edge(int i, int j) const {
        const Seen& seen = at_centre(i, j);
        return any_around(i, j, [&](const Seen& other) { return other.part != seen.part; });
    }

    /// True if a depth lies between those that are seen in the pixel.
    bool is_around(int i, int j, double depth) const {
        const bool above = any_around(i, j, [=](const Seen& s) { return s.depth >= depth; });
        return above && any_around(i, j, [=](const Seen& s) { return s.depth <= depth; });
    }

    Ray ray(int i, int j) const {
        return ray_through(query_.camera, query_.width, query_.height, i + 0.5, j + 0.5);
    }

private:
    const Seen& at(int a, int b) const {
        return seen_[static_cast<std::size_t>(b) * (2 * query_.width + 1) + a];
    }

    Seen look(double x, double y) const {
        const Ray ray = ray_through(query_.camera, query_.width, query_.height, x, y);
        Seen seen;
        for (const Crossing& crossing : sheet_(ray)) {
            if (crossing.t < 0) continue;
            if (seen.crossings++ == 0) {
                const glm::dvec3 n = glm::normalize(crossing.normal);
                seen.depth = crossing.t;
                seen.part = crossing.part;
                seen.normal = glm::dot(n, ray.direction) > 0 ? -n : n;
            }
        }
        if (is_solid_ && std::ranges::any_of(solid_(ray), [](const Span& span) {
                return span.enter.t <= 0 && span.leave.t >= 0;
            })) {
            seen.depth = 0;
            seen.normal = glm::dvec3(0);
        }
        return seen;
    }

    template <class Predicate>
    bool any_around(int i, int j, Predicate predicate) const {
        for (int b = 2 * j; b <= 2 * j + 2; ++b) {
            for (int a = 2 * i; a <= 2 * i + 2; ++a) {
                if (predicate(at(a, b))) return true;
            }
        }
        return false;
    }

    const Query& query_;
    bool is_solid_;
    Solid solid_ = nothing();
    Sheet sheet_;
    std::vector<Seen> seen_;  ///< at centres, corners and middles of edges of all pixels
};

void note(Agreement& agreement, int i, int j, const std::string& what) {
    constexpr int most_examples = 6;
    if (agreement.wrong() <= most_examples) {
        agreement.examples += fmt::format("\n  pixel {},{}: {}", i, j, what);
    }
}

void compare_depth(Agreement& agreement, double expected, double actual, int i, int j) {
    const double error = std::abs(actual - expected) / std::max(expected, 1e-30);
    if (!(error <= agreement.depth_error)) agreement.depth_error = error;
    if (error <= depth_tolerance) return;
    ++agreement.off_depth;
    note(agreement, i, j, fmt::format("depth {:.9g} instead of {:.9g}", actual, expected));
}

void compare_normal(Agreement& agreement, const glm::dvec3& expected, const glm::dvec3& actual,
                    const glm::dvec3& direction, int i, int j) {
    const bool sound =
        std::abs(glm::length(actual) - 1) <= 1e-5 && glm::dot(actual, direction) <= 1e-6;
    const double sine = glm::length(glm::cross(expected, actual));
    const double angle = std::atan2(sine, glm::dot(expected, actual));
    if (!(angle <= agreement.normal_error)) agreement.normal_error = angle;
    if (sound && angle < normal_tolerance) return;
    ++agreement.off_normal;
    note(agreement, i, j,
         fmt::format("normal {:.4g},{:.4g},{:.4g} instead of {:.4g},{:.4g},{:.4g}", actual.x,
                     actual.y, actual.z, expected.x, expected.y, expected.z));
}

}  // namespace

std::ostream& operator<<(std::ostream& stream, const Answer& answer) {
    return stream << answer.name;
}

std::ostream& operator<<(std::ostream& stream, const Agreement& a) {
    return stream << fmt::format(
               "{} compared, {} missed, {} phantom, {} off in depth (worst {:.3g}), {} off in "
               "normal (worst {:.3g} rad), {} unresolved{}",
               a.compared, a.missed, a.phantom, a.off_depth, a.depth_error, a.off_normal,
               a.normal_error, a.unresolved, a.examples);
}

Agreement compare(const Answer& answer) { return compare(answer, render(answer.query)); }

Agreement compare(const Answer& answer, const render::Still& still) {
    const Eye eye(answer);
    Agreement agreement;
    if (still.geometry.width != answer.query.width) {
        agreement.missed = answer.query.width * answer.query.height;
        return agreement;
    }
    for (int j = 0; j < still.geometry.height; ++j) {
        for (int i = 0; i < still.geometry.width; ++i) {
            const Seen& seen = eye.at_centre(i, j);
            if (eye.at_silhouette(i, j)) continue;
            ++agreement.compared;
            if (status(still, i, j) == shader::Status::unresolved) {
                ++agreement.unresolved;
                continue;
            }
            const bool hit = std::isfinite(seen.depth);
            const bool found = std::isfinite(depth(still, i, j));
            agreement.missed += hit && !found;
            agreement.phantom += !hit && found;
            if (hit != found) {
                note(agreement, i, j, hit ? "missed" : "phantom");
                continue;
            }
            if (!hit) continue;
            if (eye.at_edge(i, j) && eye.is_around(i, j, depth(still, i, j))) continue;
            compare_depth(agreement, seen.depth, depth(still, i, j), i, j);
            if (seen.depth > 0) {
                compare_normal(agreement, seen.normal, normal(still, i, j), eye.ray(i, j).direction,
                               i, j);
            }
        }
    }
    return agreement;
}

}  // namespace render_answers
