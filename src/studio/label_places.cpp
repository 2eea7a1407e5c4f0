// SPDX-License-Identifier: MIT
#include "studio/label_places.h"

#include <algorithm>
#include <array>

namespace studio {
namespace {

bool overlap(const PlotBox& a, const PlotBox& b) {
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

bool inside(const PlotBox& box, const PlotBox& frame) {
    return box.left >= frame.left && box.right <= frame.right && box.top >= frame.top &&
           box.bottom <= frame.bottom;
}

/// To the right, above, below, to the left, and the corners, in the order of preference.
std::array<LabelPlace, 8> candidates(const LabelledPoint& p, double radius) {
    const double right = p.x + radius + 1, left = p.x - radius - 1 - p.width;
    const double above = p.y - radius - p.height, below = p.y + radius;
    const double centre = p.x - p.width / 2, middle = p.y - p.height / 2;
    return {{{right, middle},
             {centre, above},
             {centre, below},
             {left, middle},
             {right, above},
             {right, below},
             {left, above},
             {left, below}}};
}

}  // namespace

std::vector<std::optional<LabelPlace>> label_places(std::span<const LabelledPoint> points,
                                                    const PlotBox& frame, double radius) {
    std::vector<PlotBox> taken;
    for (const LabelledPoint& p : points) {
        taken.push_back({p.x - radius, p.y - radius, p.x + radius, p.y + radius});
    }
    std::vector<std::optional<LabelPlace>> places;
    for (const LabelledPoint& p : points) {
        places.emplace_back();
        if (p.width <= 0) continue;
        for (const LabelPlace& corner : candidates(p, radius)) {
            const PlotBox box{corner.x, corner.y, corner.x + p.width, corner.y + p.height};
            const auto covers = [&](const PlotBox& other) { return overlap(box, other); };
            if (!inside(box, frame) || std::ranges::any_of(taken, covers)) continue;
            places.back() = corner;
            taken.push_back(box);
            break;
        }
    }
    return places;
}

}  // namespace studio
