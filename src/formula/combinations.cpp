// SPDX-License-Identifier: MIT
#include "formula/combinations.h"

#include <algorithm>

#include "formula/combination_builders.h"

namespace formula {
namespace {

constexpr Combination table[] = {
    {"bend", "bend(F, curvature)", build_bend},
    {"colour", "colour(F, c)", build_colour},
    {"complement", "complement(F)", build_complement},
    {"difference", "difference(F, G)", build_difference},
    {"displace", "displace(F, by)", build_displace},
    {"intersection", "intersection(F, G, ...)", build_intersection},
    {"map", "map(F, m)", build_map},
    {"mirror", "mirror(F, (nx, ny, nz), d = 0)", build_mirror},
    {"morph", "morph(F, G, t)", build_morph},
    {"offset", "offset(F, d)", build_offset},
    {"repeat", "repeat(F, (cx, cy, cz), count = (nx, ny, nz))", build_repeat},
    {"repeat_polar", "repeat_polar(F, n)", build_repeat_polar},
    {"rotate", "rotate(F, (nx, ny, nz), degrees)", build_rotate},
    {"scale", "scale(F, factor)", build_scale},
    {"shell", "shell(F, thickness = 0.1)", build_shell},
    {"smooth_difference", "smooth_difference(F, G, k = 0.25)", build_smooth_difference},
    {"smooth_intersection", "smooth_intersection(F, G, k = 0.25)", build_smooth_intersection},
    {"smooth_union", "smooth_union(F, G, ..., k = 0.25)", build_smooth_union},
    {"smooth_union_exp", "smooth_union_exp(F, G, k = 8)", build_smooth_union_exp},
    {"smooth_union_power", "smooth_union_power(F, G, p = 4)", build_smooth_union_power},
    {"translate", "translate(F, (dx, dy, dz))", build_translate},
    {"twist", "twist(F, angle)", build_twist},
    {"union", "union(F, G, ...)", build_union},
};

}  // namespace

std::span<const Combination> combinations() { return table; }

const Combination* find_combination(std::string_view name) {
    const auto* const found = std::ranges::find(table, name, &Combination::name);
    return found == std::end(table) ? nullptr : found;
}

}  // namespace formula
