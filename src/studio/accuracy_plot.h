// SPDX-License-Identifier: MIT
// What the plot of wrong pixels against time shows.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "studio/accuracy.h"
#include "studio/log_axis.h"

namespace studio {

struct PlotPoint {
    std::size_t index = 0;  ///< into Accuracy::measured
    double milliseconds = 0;
    double wrong = 0;      ///< pixels
    bool present = false;  ///< the setting in force
    bool alike = false;    ///< steps and epsilon are those in force
    std::string label;     ///< empty: none
};

/// Points that belong together: one tracer with several Lipschitz scales, in the order of these.
using PlotCurve = std::vector<std::size_t>;

struct AccuracyPlot {
    std::vector<PlotPoint> points;  ///< the present one first: its label goes before all others
    std::vector<PlotCurve> curves;  ///< indices into the points
    LogAxis milliseconds, wrong;
};

/// All settings that are both judged and timed. The label of a point is its tracer, of those of a
/// curve the Lipschitz scale (of the first one both); points with other steps or another epsilon
/// have none and are on no curve.
AccuracyPlot accuracy_plot(const Accuracy& accuracy, const Tracing& present);

}  // namespace studio
