// SPDX-License-Identifier: MIT
#include "studio/accuracy_plot.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace studio {
namespace {

std::vector<PlotPoint> points_of(const Accuracy& accuracy, const Tracing& present) {
    std::vector<PlotPoint> points;
    for (std::size_t i = 0; i < accuracy.measured.size(); ++i) {
        const MeasuredSetting& setting = accuracy.measured[i];
        const auto seconds = setting.frame_seconds();
        if (!setting.judged || !seconds) continue;
        const Tracing& tracing = setting.tracing;
        points.push_back(
            {.index = i,
             .milliseconds = 1000 * *seconds,
             .wrong = static_cast<double>(setting.judged->metrics.wrong()),
             .present = tracing == present,
             .alike = tracing.steps == present.steps && tracing.epsilon == present.epsilon,
             .label = {}});
    }
    std::ranges::stable_partition(points, &PlotPoint::present);
    return points;
}

}  // namespace

AccuracyPlot accuracy_plot(const Accuracy& accuracy, const Tracing& present) {
    AccuracyPlot plot;
    plot.points = points_of(accuracy, present);
    std::map<std::string, PlotCurve> by_tracer;
    std::vector<double> milliseconds, wrong;
    for (std::size_t i = 0; i < plot.points.size(); ++i) {
        milliseconds.push_back(plot.points[i].milliseconds);
        wrong.push_back(plot.points[i].wrong);
        const Tracing& tracing = accuracy.measured[plot.points[i].index].tracing;
        if (plot.points[i].alike) by_tracer[tracing.tracer].push_back(i);
    }
    const auto scale = [&](std::size_t point) {
        return accuracy.measured[plot.points[point].index].tracing.lipschitz;
    };
    for (auto& [tracer, curve] : by_tracer) {
        std::ranges::sort(curve, {}, scale);
        for (const std::size_t point : curve) {
            plot.points[point].label = fmt::format("{:.3g}", scale(point));
        }
        std::string& first = plot.points[curve.front()].label;
        first = curve.size() == 1 ? tracer : tracer + " " + first;
        if (curve.size() > 1) plot.curves.push_back(curve);
    }
    plot.milliseconds = log_axis(milliseconds, false);
    plot.wrong = log_axis(wrong, true);
    return plot;
}

}  // namespace studio
