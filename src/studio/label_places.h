// SPDX-License-Identifier: MIT
// Where the labels of a plot's points stand so that none covers another.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace studio {

struct PlotBox {
    double left = 0, top = 0, right = 0, bottom = 0;
};

/// A point with its label's size, in pixels.
struct LabelledPoint {
    double x = 0, y = 0;
    double width = 0, height = 0;
};

/// The top left corner of each label, beside its point: none where it would leave the frame, or
/// cover a point or the label of an earlier one. All points keep free a square of `radius` around
/// them.
struct LabelPlace {
    double x = 0, y = 0;
};
std::vector<std::optional<LabelPlace>> label_places(std::span<const LabelledPoint> points,
                                                    const PlotBox& frame, double radius);

}  // namespace studio
