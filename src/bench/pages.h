// SPDX-License-Identifier: MIT
// The pages of docs/ that are made of a run.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/result.h"
#include "bench/report.h"

namespace bench {

/// What tracers got wrong in one scene of the torture suite.
struct TortureScene {
    std::string name;
    bool smooth = false;  ///< proven of its formula; not in the record
    std::size_t compared = 0, undecided = 0;
    struct Counts {
        std::size_t missed = 0, phantom = 0, moved = 0, unresolved = 0;
    };
    std::map<std::string, Counts> tracers;
};

/// Reads tests/torture/known_failures.json. Error: it is no such file.
base::Result<std::vector<TortureScene>> read_torture(std::string_view text,
                                                     const std::string& name);

/// From which zoom on single precision no longer shows a fractal, and how it comes to that.
struct PrecisionLimit {
    std::string fractal;
    double zoom = 0;  ///< the last that was good
    struct Step {
        double zoom = 0, wrong_share = 0;
    };
    std::vector<Step> steps;
};

/// Reads tests/torture/precision_limits.json. Error: it is no such file.
base::Result<std::vector<PrecisionLimit>> read_precision_limits(std::string_view text,
                                                                const std::string& name);

/// Geometric means of each tracer's times to those of the shaders by hand and of the limit, with
/// the number of presets that have both, as a table in Markdown.
std::string means_table(const Report& report);

/// docs/performance.md: what was asked and reached (of the torture scenes only their wrong pixels),
/// times, ratios to the shaders by hand and to the limit, where a frame goes.
std::string performance_page(const Report& report, const std::vector<TortureScene>& torture);

/// docs/accuracy.md: wrong pixels, errors of depth, what the reference could not decide, what the
/// settings buy, the torture scenes, and how deep zooms go, as far as they are given.
std::string accuracy_page(const Report& report, const std::vector<TortureScene>& torture,
                          const std::vector<PrecisionLimit>& limits);

}  // namespace bench
