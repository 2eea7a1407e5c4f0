// SPDX-License-Identifier: MIT
#include "bench/generated.h"

#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include <fmt/format.h>

namespace bench {
namespace {

/// The i-th of so many places in the unit disc (Vogel's spiral), which are about equally far apart.
std::string ball(int i, int count, double z) {
    const double radius = std::sqrt((i + 0.5) / count);
    const double angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
    return fmt::format("ball({:.3f}, {:.3f}, {:.3f})", radius * std::cos(angle),
                       radius * std::sin(angle), z);
}

/// As flat as can be: brackets have a limit.
std::string blended(std::span<const std::string> balls) {
    if (balls.size() == 1) return balls[0];
    const std::size_t half = balls.size() / 2;
    return fmt::format("join({}, {})", blended(balls.first(half)), blended(balls.subspan(half)));
}

std::vector<std::string> balls(int count, double z) {
    std::vector<std::string> list;
    for (int i = 0; i < count; ++i) list.push_back(ball(i, count, z));
    return list;
}

}  // namespace

std::string many_primitives(int count) {
    const double size = 0.62 / std::sqrt(count);
    const int bites = count / 5;
    return fmt::format(
        "ball(a, b, c) = translate(sphere({:.4f}), (a, b, c))\n"
        "join(f, g) = smooth_union(f, g, {:.4f})\n"
        "smooth_difference({}, {}, {:.4f})\n",
        size, 0.3 * size, blended(balls(count - bites, 0)), blended(balls(bites, 0.8 * size)),
        0.3 * size);
}

std::optional<scene::Document> generated_scene(std::string_view name) {
    if (name != few_name && name != many_name) return std::nullopt;
    scene::Document document;
    document.title = std::string(name);
    document.formula = many_primitives(name == few_name ? 10 : 1000);
    document.bounds.half = glm::dvec3(1.4);
    document.camera = scene::Camera{{0.6, 0.8, 3.2}, {0, 0, 0}, {0, 1, 0}, 45};
    return document;
}

}  // namespace bench
