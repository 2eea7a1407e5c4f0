// SPDX-License-Identifier: MIT
#include "studio/marked_areas.h"

#include <cassert>

namespace studio {
namespace {

/// Right where nothing is to be marked.
oracle::Judgement mark_at(const oracle::Reference& reference, const oracle::Metrics& metrics,
                          std::size_t index) {
    const oracle::Judgement judgement = metrics.judgements[index];
    const bool fragile = judgement == oracle::Judgement::excused &&
                         reference.pixels[index].verdict != oracle::Verdict::undecided;
    return fragile ? oracle::Judgement::right : judgement;
}

/// The runs of equal marks in one row.
std::vector<MarkedArea> runs(const oracle::Reference& reference, const oracle::Metrics& metrics,
                             int y) {
    std::vector<MarkedArea> list;
    const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(reference.width);
    for (int x = 0; x < reference.width; ++x) {
        const auto mark = mark_at(reference, metrics, row + static_cast<std::size_t>(x));
        if (mark == oracle::Judgement::right) continue;
        const bool goes_on = !list.empty() && list.back().judgement == mark &&
                             list.back().x + list.back().width == x;
        if (goes_on) {
            ++list.back().width;
        } else {
            list.push_back({x, y, 1, 1, mark});
        }
    }
    return list;
}

bool continues(const MarkedArea& above, const MarkedArea& run) {
    return above.x == run.x && above.width == run.width && above.judgement == run.judgement;
}

}  // namespace

std::vector<MarkedArea> marked_areas(const oracle::Reference& reference,
                                     const oracle::Metrics& metrics) {
    assert(metrics.judgements.size() == reference.pixels.size());
    std::vector<MarkedArea> areas;
    std::vector<std::size_t> above;  // the areas that end with the row before
    for (int y = 0; y < reference.height; ++y) {
        std::vector<std::size_t> ending;
        auto candidate = above.begin();
        for (const MarkedArea& run : runs(reference, metrics, y)) {
            while (candidate != above.end() && areas[*candidate].x < run.x) ++candidate;
            if (candidate != above.end() && continues(areas[*candidate], run)) {
                ++areas[*candidate].height;
                ending.push_back(*candidate);
            } else {
                ending.push_back(areas.size());
                areas.push_back(run);
            }
        }
        above = std::move(ending);
    }
    return areas;
}

}  // namespace studio
