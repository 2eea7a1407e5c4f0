// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "bench/markdown.h"
#include "bench/page_parts.h"
#include "bench/pages.h"
#include "bench/statistics.h"
#include "bench/targets.h"

namespace bench {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string milliseconds(const Entry* entry) {
    return entry ? fmt::format("{:.2f}", 1e3 * quantile(entry->seconds, 0.5)) : "";
}

/// "1.03 (41 presets)": the geometric mean of a tracer's ratios to something, over those presets
/// that have it.
std::string mean_ratio(const Report& report, const std::string& tracer, std::string_view to,
                       bool smooth_only) {
    std::vector<double> ratios;
    for (const PresetReport& preset : report.presets) {
        if (smooth_only && !preset.smooth) continue;
        const Entry* entry = find(preset, tracer);
        const Entry* other = find(preset, std::string(to));
        const auto ratio = entry ? time_ratio(*entry, other) : std::nullopt;
        if (ratio) ratios.push_back(*ratio);
    }
    if (ratios.empty()) return "";
    return fmt::format("{:.2f} ({})", geometric_mean(ratios), ratios.size());
}

std::string times(const Report& report) {
    std::vector<std::string> columns = tracer_names(report);
    for (const std::string_view name :
         {plain_name, plain_sphere_name, plain_first_order_name, limit_name}) {
        columns.emplace_back(name);
    }
    Rows rows{{"preset"}};
    rows[0].insert(rows[0].end(), columns.begin(), columns.end());
    for (const PresetReport& preset : report.presets) {
        rows.push_back({preset.preset});
        for (const std::string& name : columns) {
            rows.back().push_back(milliseconds(find(preset, name)));
        }
    }
    return markdown_table(rows);
}

std::string ratios(const Report& report) {
    Rows rows{{"preset", "quartiles, ms", "to plain", "to limit", "evaluations a pixel"}};
    for (const PresetReport& preset : report.presets) {
        const Entry* entry = find(preset, "auto");
        if (!entry) continue;
        const Quartiles q = quartiles(entry->seconds);
        const auto ratio = [&](const Entry* other) {
            const auto value = time_ratio(*entry, other);
            return value ? fmt::format("{:.2f}", *value) : std::string();
        };
        rows.push_back({preset.preset, fmt::format("{:.2f}-{:.2f}", 1e3 * q.lower, 1e3 * q.upper),
                        ratio(plain_of(preset)), ratio(find(preset, std::string(limit_name))),
                        entry->evaluations ? fmt::format("{:.1f}", *entry->evaluations) : ""});
    }
    return markdown_table(rows);
}

std::string passes(const Report& report) {
    Rows rows{{"preset", "tracer", "to the surface", "normal", "light", "shadows", "parse, ms",
               "analysis, ms", "link, ms", "first frame, ms", "slider, ms", "to its picture, ms"}};
    for (const PresetReport& preset : report.presets) {
        for (const Entry& entry : preset.entries) {
            if (!entry.passes) continue;
            rows.push_back({preset.preset, entry.tracer});
            for (const double share : shares(*entry.passes)) {
                rows.back().push_back(fmt::format("{:.0f} %", 100 * share));
            }
            rows.back().push_back(fmt::format("{:.1f}", 1e3 * preset.parse_seconds));
            rows.back().push_back(fmt::format("{:.1f}", 1e3 * preset.analyse_seconds));
            rows.back().push_back(fmt::format("{:.0f}", 1e3 * entry.link_seconds));
            rows.back().push_back(fmt::format("{:.0f}", 1e3 * entry.first_frame_seconds));
            const auto& slider = preset.slider;
            rows.back().push_back(slider ? fmt::format("{:.1f}{}", 1e3 * slider->before_seconds,
                                                       slider->coarse ? ", coarse" : "")
                                         : "");
            rows.back().push_back(slider ? fmt::format("{:.1f}", 1e3 * slider->picture_seconds)
                                         : "");
        }
    }
    return markdown_table(rows);
}

}  // namespace

std::string means_table(const Report& report) {
    Rows rows{{"tracer", "plain first-order, smooth presets", "plain sphere, smooth presets",
               "plain fractals", "limit, all presets"}};
    for (const std::string& tracer : tracer_names(report)) {
        rows.push_back({tracer, mean_ratio(report, tracer, plain_first_order_name, true),
                        mean_ratio(report, tracer, plain_sphere_name, true),
                        mean_ratio(report, tracer, plain_name, false),
                        mean_ratio(report, tracer, limit_name, false)});
    }
    return markdown_table(rows);
}

std::string performance_page(const Report& report, const std::vector<TortureScene>& torture) {
    std::string page =
        "# Performance\n\n"
        "How long a frame takes, and what that is worth. The errors of the same run are on "
        "[another page](accuracy.md).\n\n";
    page += run_description(report);
    page +=
        "## What was asked\n\nWith the tracer auto. The time from text to picture is that of "
        "parsing, analysis, linking and the first frame; what is below is not rounded in our "
        "favour.\n\n" +
        targets_table(targets(report, torture));
    page +=
        "## What it is compared with\n\n"
        "- **plain**: the shader that people write by hand (`tests/bench/plain/`). For fractals "
        "the "
        "usual distance estimator, with angles for the Mandelbulb, and at most 256 steps; for "
        "formulas, joined by minimum and maximum, *plain sphere*, |f| over the region's Lipschitz "
        "constant with at most 4096 "
        "steps, and *plain first-order*, |f| / |grad f| taken for a distance, which is unsafe. "
        "Normals are by six evaluations. Camera, bounds and light are the same, a shadow ray for "
        "each light.\n"
        "- **limit**: a program that is told the right depth, evaluates the field once, takes its "
        "normal and shades, without shadow rays: the least that any tracer could cost in every "
        "pixel. Only the tracers' programs leave the pixels around the bounds to a smaller one.\n\n"
        "Ratios are medians of those of single rounds, so that a slow moment does not count. Above "
        "1 is slower.\n\n";
    page += "Geometric means of the ratios (over how many presets):\n\n" + means_table(report);
    page += "## Milliseconds a frame\n\nMedians, each tracer with the preset's own settings.\n\n" +
            times(report);
    page += "## The tracer auto\n\n" + ratios(report);
    page +=
        "## Where a frame goes\n\n"
        "Shares are differences of programs that do ever more: only to the surface, with the "
        "normal, with light, with shadows. Link and first frame ";
    page += report.machine.shader_cache ? "may come from Mesa's cache on disk.\n\n"
                                        : "were measured without Mesa's cache on disk.\n\n";
    page +=
        "A slider's move is one of the formula's first number, by a hundredth of its range: what "
        "comes before drawing, with the studio's 15 ms for analyses (coarse: they had to be cut "
        "short, and are completed when the slider rests), and all until the picture is there. "
        "Nothing is linked.\n\n";
    page += passes(report);
    page.pop_back();
    return page;
}

}  // namespace bench
