// SPDX-License-Identifier: MIT
// Reports without a run.
#pragma once

#include <cmath>
#include <random>

#include "bench/report.h"

namespace bench {

inline Entry entry(const std::string& tracer, const Move& move, std::vector<double> seconds,
                   std::size_t phantom) {
    Entry e;
    e.tracer = tracer;
    e.move = move;
    e.seconds = std::move(seconds);
    e.hit = 30;
    e.miss = 70;
    e.errors = Errors{};
    e.errors->compared = 100;
    e.errors->phantom = phantom;
    e.errors->depth_99 = 1e-6;
    return e;
}

/// A preset of two tracers with two settings each, a shader by hand, and the limit.
inline Report hand_made() {
    Report report;
    report.machine = {"A processor <fast>", 2,     "osmesa", "driver & co", "4.5",
                      "2026-01-02",         "abc", true};
    report.width = 40;
    report.height = 30;
    report.reference_width = 20;
    report.reference_height = 15;
    report.rounds = 3;
    report.command = "zeroset bench";
    PresetReport preset;
    preset.preset = "surfaces/ball";
    preset.smooth = true;
    preset.yardstick_seconds = {1e-3, 2e-3, 1e-3};
    preset.settings = {{"epsilon", 0.1}, {"lipschitz", 1}, {"steps", 1024}};
    preset.entries = {entry("auto", {}, {4e-3, 8e-3, 4e-3}, 2),
                      entry("auto", {"lipschitz", 2}, {6e-3, 12e-3, 6e-3}, 1),
                      entry("sphere", {}, {10e-3, 20e-3, 10e-3}, 0),
                      entry("sphere", {"lipschitz", 2}, {14e-3, 28e-3, 14e-3}, 5),
                      entry("plain sphere", {}, {8e-3, 16e-3, 8e-3}, 50),
                      entry("limit", {}, {1e-3, 2e-3, 1e-3}, 0)};
    preset.entries.back().errors.reset();
    preset.entries[0].evaluations = 7.5;
    preset.entries[0].passes = Passes{1e-3, 2e-3, 3e-3, 4e-3};
    report.presets.push_back(preset);
    return report;
}

}  // namespace bench
