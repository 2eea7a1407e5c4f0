// SPDX-License-Identifier: MIT
#include "render_answers/exact_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include <glm/geometric.hpp>

namespace render_answers {
namespace {

constexpr double far_away = 1e4;

Polynomial along(const Function& function, const Ray& ray) {
    const auto coordinate = [&](int k) {
        return Polynomial(std::vector<double>{ray.origin[k], ray.direction[k]});
    };
    return function(coordinate(0), coordinate(1), coordinate(2));
}

/// The partial derivatives are the linear coefficients along the axes.
glm::dvec3 gradient(const Function& function, const glm::dvec3& point) {
    glm::dvec3 result{0};
    for (int k = 0; k < 3; ++k) {
        glm::dvec3 axis{0};
        axis[k] = 1;
        const Polynomial p = along(function, {point, axis});
        if (p.coefficients.size() > 1) result[k] = p.coefficients[1];
    }
    return result;
}

std::vector<Crossing> crossings(const Function& function, const Ray& ray) {
    std::vector<Crossing> list;
    for (const double t : sign_changes(along(function, ray), -far_away, far_away)) {
        list.push_back({t, gradient(function, ray.at(t)), &function});
    }
    return list;
}

bool is_inside(const std::vector<Span>& spans, double t) {
    return std::ranges::any_of(spans,
                               [t](const Span& s) { return s.enter.t <= t && t <= s.leave.t; });
}

/// The stretches where both or one of two lists are inside.
std::vector<Span> merge(const std::vector<Span>& a, const std::vector<Span>& b, bool both) {
    std::vector<Crossing> events{{-far_away, {}}};
    for (const auto* list : {&a, &b}) {
        for (const Span& span : *list) {
            events.push_back(span.enter);
            events.push_back(span.leave);
        }
    }
    events.push_back({far_away, {}});
    std::ranges::sort(events, {}, &Crossing::t);
    std::vector<Span> result;
    for (std::size_t k = 0; k + 1 < events.size(); ++k) {
        const double middle = (events[k].t + events[k + 1].t) / 2;
        const bool in_a = is_inside(a, middle);
        const bool in_b = is_inside(b, middle);
        if (events[k].t == events[k + 1].t || !(both ? in_a && in_b : in_a || in_b)) continue;
        if (!result.empty() && result.back().leave.t == events[k].t) {
            result.back().leave = events[k + 1];
        } else {
            result.push_back({events[k], events[k + 1]});
        }
    }
    return result;
}

}  // namespace

Solid below(Function function) {
    return [function = std::move(function)](const Ray& ray) {
        std::vector<Crossing> ends = crossings(function, ray);
        const Polynomial p = along(function, ray);
        ends.insert(ends.begin(), Crossing{-far_away, {}});
        ends.push_back({far_away, {}});
        std::vector<Span> result;
        for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
            if (p.at((ends[k].t + ends[k + 1].t) / 2) < 0) result.push_back({ends[k], ends[k + 1]});
        }
        return result;
    };
}

Solid operator&(Solid a, Solid b) {
    return [a = std::move(a), b = std::move(b)](const Ray& ray) {
        return merge(a(ray), b(ray), true);
    };
}

Solid operator|(Solid a, Solid b) {
    return [a = std::move(a), b = std::move(b)](const Ray& ray) {
        return merge(a(ray), b(ray), false);
    };
}

Solid operator!(Solid a) {
    return [a = std::move(a)](const Ray& ray) {
        Crossing begin{-far_away, {}};
        std::vector<Span> result;
        for (const Span& span : a(ray)) {
            if (span.enter.t > begin.t) result.push_back({begin, span.enter});
            begin = span.leave;
        }
        if (begin.t < far_away) result.push_back({begin, {far_away, {}}});
        return result;
    };
}

Solid nothing() {
    return [](const Ray&) { return std::vector<Span>{}; };
}

Solid half_space(double a, double b, double c, double d) {
    const glm::dvec3 normal(a, b, c);
    const auto part = std::make_shared<int>();
    return [=](const Ray& ray) -> std::vector<Span> {
        const double height = glm::dot(normal, ray.origin) - d;
        const double rate = glm::dot(normal, ray.direction);
        const Span all{{-far_away, {}}, {far_away, {}}};
        if (rate == 0) return height < 0 ? std::vector{all} : std::vector<Span>{};
        const Crossing wall{-height / rate, normal, part.get()};
        if (!(std::abs(wall.t) < far_away))
            return height < 0 ? std::vector{all} : std::vector<Span>{};
        return {rate > 0 ? Span{all.enter, wall} : Span{wall, all.leave}};
    };
}

Solid ball(double radius, glm::dvec3 centre) {
    return below([=](const Polynomial& x, const Polynomial& y, const Polynomial& z) {
        const Polynomial u = x - centre.x;
        const Polynomial v = y - centre.y;
        const Polynomial w = z - centre.z;
        return u * u + v * v + w * w - radius * radius;
    });
}

Solid cuboid(glm::dvec3 half, glm::dvec3 centre) {
    const auto walls = std::make_shared<std::array<int, 6>>();
    return [=](const Ray& ray) -> std::vector<Span> {
        Span inside{{-far_away, {}}, {far_away, {}}};
        for (int axis = 0; axis < 3; ++axis) {
            const double from = ray.origin[axis] - centre[axis], rate = ray.direction[axis];
            if (rate == 0) {
                if (!(std::abs(from) < half[axis])) return {};
                continue;
            }
            const auto crossing = [&](int side) {
                glm::dvec3 normal(0);
                normal[axis] = side;
                return Crossing{(side * half[axis] - from) / rate, normal,
                                walls->data() + 2 * axis + (side > 0)};
            };
            const int first = rate > 0 ? -1 : 1;
            const Crossing enter = crossing(first), leave = crossing(-first);
            if (enter.t > inside.enter.t) inside.enter = enter;
            if (leave.t < inside.leave.t) inside.leave = leave;
        }
        if (!(inside.enter.t < inside.leave.t)) return {};
        return {inside};
    };
}

Solid torus(double large, double small) {
    return below([=](const Polynomial& x, const Polynomial& y, const Polynomial& z) {
        const Polynomial around = x * x + y * y;
        const Polynomial sum = around + z * z + (large * large - small * small);
        return sum * sum - 4 * large * large * around;
    });
}

Solid cylinder(double radius, double half_height) {
    return below([=](const Polynomial& x, const Polynomial& y, const Polynomial&) {
               return x * x + y * y - radius * radius;
           }) &
           half_space(0, 0, 1, half_height) & half_space(0, 0, -1, half_height);
}

Solid cone(double radius, double half_height) {
    return below([=](const Polynomial& x, const Polynomial& y, const Polynomial& z) {
               const Polynomial width = (half_height - z) * (radius / (2 * half_height));
               return x * x + y * y - width * width;
           }) &
           half_space(0, 0, 1, half_height) & half_space(0, 0, -1, half_height);
}

Solid capsule(double radius, double half_height) {
    return cylinder(radius, half_height) | ball(radius, {0, 0, half_height}) |
           ball(radius, {0, 0, -half_height});
}

Solid inside(const scene::Bounds& bounds) {
    switch (bounds.shape) {
        case scene::Bounds::Shape::sphere:
            return ball(bounds.half.x, bounds.centre);
        case scene::Bounds::Shape::box:
            return cuboid(bounds.half, bounds.centre);
        case scene::Bounds::Shape::none:
            break;
    }
    return !nothing();
}

Sheet zeros(Function function) {
    return [function = std::move(function)](const Ray& ray) { return crossings(function, ray); };
}

Sheet operator&(Sheet sheet, Solid solid) {
    return [sheet = std::move(sheet), solid = std::move(solid)](const Ray& ray) {
        std::vector<Crossing> list = sheet(ray);
        const std::vector<Span> spans = solid(ray);
        std::erase_if(list, [&](const Crossing& c) { return !is_inside(spans, c.t); });
        return list;
    };
}

Sheet operator|(Sheet a, Sheet b) {
    return [a = std::move(a), b = std::move(b)](const Ray& ray) {
        std::vector<Crossing> list = a(ray);
        for (const Crossing& crossing : b(ray)) list.push_back(crossing);
        std::ranges::sort(list, {}, &Crossing::t);
        return list;
    };
}

Sheet boundary(Solid solid) {
    return [solid = std::move(solid)](const Ray& ray) {
        std::vector<Crossing> list;
        for (const Span& span : solid(ray)) {
            if (span.enter.t > -far_away) list.push_back(span.enter);
            if (span.leave.t < far_away) list.push_back(span.leave);
        }
        return list;
    };
}

}  // namespace render_answers
