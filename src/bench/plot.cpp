// SPDX-License-Identifier: MIT
#include "bench/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace bench {
namespace {

constexpr double left = 64, right = 500, top = 14, bottom = 300;
constexpr double width = 680, height = 344;

/// Told apart also by those who do not see red and green (Okabe and Ito 2008), and two greys.
constexpr std::array colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00",
                             "#56b4e9", "#7f7f7f", "#000000", "#a0522d", "#6a3d9a"};

/// A logarithmic axis from some power of ten to another, along some pixels.
struct Axis {
    double least = 1, most = 10;  ///< of the values
    double from = 0, to = 1;      ///< pixels

    double place(double value) const {
        const double part =
            std::log(std::clamp(value, least, most) / least) / std::log(most / least);
        return std::lerp(from, to, part);
    }
};

/// 1, 2 and 5 times powers of ten.
double below(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    const double digit = value / power;
    return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}
double next(double tick) {
    const double power = std::pow(10, std::floor(std::log10(tick * 1.0001)));
    const double digit = tick / power;
    return power * (digit >= 4.9 ? 10 : digit >= 1.9 ? 5 : 2);
}

struct Axes {
    Axis x, y;
};

Axes axes_of(const std::vector<Curve>& curves, double least_error) {
    double fastest = 1e30, slowest = 0, worst = least_error;
    for (const Curve& curve : curves) {
        for (const Trade& trade : curve.trades) {
            fastest = std::min(fastest, trade.seconds);
            slowest = std::max(slowest, trade.seconds);
            worst = std::max(worst, trade.error);
        }
    }
    if (slowest <= 0) fastest = slowest = 1;
    return {{below(fastest), next(below(slowest)), left, right},
            {least_error, std::max(10 * least_error, 1.3 * worst), bottom, top}};
}

std::string line(double x1, double y1, double x2, double y2) {
    return fmt::format("<line x1='{:.1f}' y1='{:.1f}' x2='{:.1f}' y2='{:.1f}' class='grid'/>\n", x1,
                       y1, x2, y2);
}

std::string text(double x, double y, std::string_view anchor, std::string_view content) {
    return fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='{}'>{}</text>\n", x, y, anchor,
                       escaped(content));
}

std::string grid(const Axes& axes) {
    std::string svg;
    for (double tick = axes.x.least; tick <= axes.x.most * 1.001; tick = next(tick)) {
        const double x = axes.x.place(tick);
        svg += line(x, top, x, bottom);
        svg += text(x, bottom + 16, "middle", fmt::format("{:g}", 1e3 * tick));
    }
    svg += line(left, bottom, right, bottom) + text(left - 6, bottom + 4, "end", "0");
    const double first = std::pow(10, std::ceil(std::log10(axes.y.least * 1.3)));
    for (double tick = first; tick <= axes.y.most; tick *= 10) {
        const double y = axes.y.place(tick);
        svg += line(left, y, right, y);
        svg += text(left - 6, y + 4, "end", fmt::format("{:g} %", 100 * tick));
    }
    svg += text(0.5 * (left + right), bottom + 36, "middle", "milliseconds a frame");
    svg += fmt::format(
        "<text transform='translate(12 {:.1f}) rotate(-90)' text-anchor='middle'>wrong "
        "pixels</text>\n",
        0.5 * (top + bottom));
    return svg;
}

std::string polyline(const Axes& axes, const Curve& curve, std::string_view colour) {
    std::string points;
    for (const Trade& t : curve.trades) {
        points += fmt::format("{:.1f},{:.1f} ", axes.x.place(t.seconds), axes.y.place(t.error));
    }
    return fmt::format("<polyline points='{}' fill='none' stroke='{}' stroke-width='1.3'{}/>\n",
                       points, colour, curve.moving == "epsilon" ? " stroke-dasharray='5 3'" : "");
}

std::string marks(const Axes& axes, const Curve& curve, std::string_view colour,
                  std::vector<bool>::const_iterator on_front) {
    std::string svg;
    for (std::size_t i = 0; i < curve.trades.size(); ++i, ++on_front) {
        const Trade& t = curve.trades[i];
        const double x = axes.x.place(t.seconds), y = axes.y.place(t.error);
        if (*on_front) {
            svg += fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='7.5' class='front'/>\n", x, y);
        }
        svg += fmt::format(
            "<circle cx='{:.1f}' cy='{:.1f}' r='3.6' fill='{}'><title>{}: {:.2f} ms, {:.4f} % "
            "wrong</title></circle>\n",
            x, y, colour, escaped(curve.name + ", " + curve.labels[i]), 1e3 * t.seconds,
            100 * t.error);
    }
    return svg;
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string safe;
    for (const char c : text) {
        switch (c) {
            case '&':
                safe += "&amp;";
                break;
            case '<':
                safe += "&lt;";
                break;
            case '>':
                safe += "&gt;";
                break;
            case '\'':
                safe += "&#39;";
                break;
            case '"':
                safe += "&quot;";
                break;
            default:
                safe += c;
        }
    }
    return safe;
}

std::string svg_plot(const std::vector<Curve>& curves, double least_error) {
    const Axes axes = axes_of(curves, least_error);
    std::vector<Trade> all;
    std::vector<std::string> names;
    for (const Curve& curve : curves) {
        all.insert(all.end(), curve.trades.begin(), curve.trades.end());
        if (std::ranges::find(names, curve.name) == names.end()) names.push_back(curve.name);
    }
    const std::vector<bool> front = pareto_front(all);
    std::string svg = fmt::format("<svg viewBox='0 0 {:.0f} {:.0f}' width='{:.0f}' role='img'>\n{}",
                                  width, height, width, grid(axes));
    const auto colour = [&](const std::string& name) {
        const auto number = std::ranges::find(names, name) - names.begin();
        return colours[static_cast<std::size_t>(number) % colours.size()];
    };
    for (const Curve& curve : curves) svg += polyline(axes, curve, colour(curve.name));
    auto on_front = front.begin();
    for (const Curve& curve : curves) {
        svg += marks(axes, curve, colour(curve.name), on_front);
        on_front += static_cast<std::ptrdiff_t>(curve.trades.size());
    }
    double y = top + 8;
    for (const std::string& name : names) {
        svg += fmt::format("<circle cx='{:.0f}' cy='{:.1f}' r='4' fill='{}'/>\n", right + 22, y,
                           colour(name));
        svg += text(right + 34, y + 4, "start", name);
        y += 18;
    }
    svg += fmt::format("<circle cx='{:.0f}' cy='{:.1f}' r='7.5' class='front'/>\n", right + 22, y);
    svg += text(right + 34, y + 4, "start", "on the Pareto front");
    return svg + "</svg>\n";
}

}  // namespace bench
