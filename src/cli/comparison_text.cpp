// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/format.h>

#include "cli/comparison.h"

namespace cli {
namespace {

double percent(std::size_t part, std::size_t whole) {
    return 100 * static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(whole, 1));
}

std::string spread(const oracle::Spread& spread) {
    return fmt::format("median {:.3g}, 99 % {:.3g}, largest {:.3g}", spread.median,
                       spread.percentile_99, spread.largest);
}

}  // namespace

std::string comparison_text(const Comparison& comparison) {
    const oracle::Metrics& m = comparison.metrics;
    std::string text = fmt::format("wrong         {} of {} pixels ({:.3g} %)\n", m.wrong(),
                                   m.compared, percent(m.wrong(), m.compared));
    text += fmt::format("  missed      {}\n  phantom     {}\n", m.missed, m.phantom);
    text +=
        fmt::format("  moved       {} by more than half a pixel's footprint in depth\n", m.moved);
    if (m.no_depth > 0) {
        text +=
            fmt::format("no depth      {} of the wrong pixels are NaN or negative\n", m.no_depth);
    }
    text += fmt::format("not compared  {}: {} undecided, {} fragile\n", m.undecided + m.fragile,
                        m.undecided, m.fragile);
    text += fmt::format("depth error   {} (relative, of right hits)\n", spread(m.depth_error));
    if (comparison.has_normals) {
        text += fmt::format("normal error  {} degrees\n", spread(m.normal_error));
    }
    if (comparison.picture) {
        const image::Difference& d = *comparison.picture;
        text += fmt::format("picture       mean {:.3g}, largest {} of 255, {:.3g} % changed\n",
                            d.mean, d.largest, percent(d.changed, d.picture.values.size() / 3));
    }
    if (comparison.heuristic) {
        text +=
            "Parts of the reference rest on distance estimates of escape-time sets: they prove "
            "nothing.\n";
    }
    return text;
}

}  // namespace cli
