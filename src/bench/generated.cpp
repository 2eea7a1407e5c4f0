// SPDX-License-Identifier: MIT
#include "bench/generated.h"

#include <cmath>
#include <numbers>
#include <string>

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

std::string blended(int count, double z) {
    std::string list;
    for (int i = 0; i < count; ++i) list += ball(i, count, z) + ", ";
    return fmt::format("smooth_union({}k = width)", list);
}

}  // namespace

std::string many_primitives(int count) {
    const double size = 0.62 / std::sqrt(count);
    const int bites = count / 5;
    return fmt::format(
        "ball(a, b, c) = translate(sphere({:.4f}), (a, b, c))\n"
        "param blend = 0.3 in [0.1, 0.5]\n"
        "width = {:.4f}blend\n"
        "smooth_difference({}, {}, width)\n",
        size, size, blended(count - bites, 0), blended(bites, 0.8 * size));
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
