// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "bench/markdown.h"
#include "bench/page_parts.h"
#include "bench/pages.h"
#include "bench/statistics.h"

namespace bench {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::vector<std::string> judged_names(const Report& report) {
    std::vector<std::string> names = tracer_names(report);
    for (const std::string_view name : {plain_name, plain_sphere_name, plain_first_order_name}) {
        names.emplace_back(name);
    }
    return names;
}

const Errors* errors_of(const PresetReport& preset, const std::string& tracer) {
    const Entry* entry = find(preset, tracer);
    return entry && entry->errors ? &*entry->errors : nullptr;
}

/// What the reference itself left open is the same for all tracers.
const Errors* any_errors(const PresetReport& preset) {
    for (const Entry& entry : preset.entries) {
        if (entry.errors) return &*entry.errors;
    }
    return nullptr;
}

std::string reference_table(const Report& report) {
    Rows rows{{"preset", "reference", "undecided", "near an outline"}};
    for (const PresetReport& preset : report.presets) {
        const Errors* errors = any_errors(preset);
        if (!errors) continue;
        const double all =
            static_cast<double>(errors->compared + errors->undecided + errors->fragile) / 100;
        rows.push_back({preset.preset,
                        !preset.proven  ? "estimates"
                        : preset.smooth ? "proven, smooth"
                                        : "proven",
                        fmt::format("{:.3f} %", static_cast<double>(errors->undecided) / all),
                        fmt::format("{:.2f} %", static_cast<double>(errors->fragile) / all)});
    }
    return markdown_table(rows);
}

/// One row a preset, one column a tracer.
template <class Cell>
std::string table_of(const Report& report, const Cell& cell) {
    const std::vector<std::string> names = judged_names(report);
    Rows rows{{"preset"}};
    rows[0].insert(rows[0].end(), names.begin(), names.end());
    for (const PresetReport& preset : report.presets) {
        if (!any_errors(preset)) continue;
        rows.push_back({preset.preset});
        for (const std::string& name : names) {
            const Errors* errors = errors_of(preset, name);
            rows.back().push_back(errors ? cell(*errors) : "");
        }
    }
    return markdown_table(rows);
}

std::string wrong_pixels(const Errors& errors) {
    if (errors.wrong() == 0) return "0";
    return fmt::format("{} ({}, {}, {})", errors.wrong(), errors.missed, errors.phantom,
                       errors.moved);
}

/// Of one tracer with one setting, over all presets.
struct Bought {
    std::size_t wrong = 0, compared = 0, unresolved = 0;
    std::vector<double> ratios;  ///< of its time to that with the preset's own settings
};

std::string bought_table(const Report& report) {
    std::vector<std::pair<std::string, Move>> order;
    std::map<std::string, Bought> found;
    const auto key = [](const Entry& e) { return e.tracer + '\0' + text(e.move); };
    for (const PresetReport& preset : report.presets) {
        for (const Entry& entry : preset.entries) {
            if (!entry.errors) continue;
            if (!found.contains(key(entry))) order.emplace_back(entry.tracer, entry.move);
            Bought& bought = found[key(entry)];
            bought.wrong += entry.errors->wrong();
            bought.compared += entry.errors->compared;
            bought.unresolved += entry.unresolved;
            const auto ratio = time_ratio(entry, find(preset, entry.tracer));
            if (ratio) bought.ratios.push_back(*ratio);
        }
    }
    std::ranges::stable_sort(order, {}, [&](const auto& item) {
        const auto names = judged_names(report);
        return std::ranges::find(names, item.first) - names.begin();
    });
    Rows rows{{"tracer", "setting", "wrong pixels", "of all", "time"}};
    for (const auto& [tracer, move] : order) {
        Entry wanted;
        wanted.tracer = tracer;
        wanted.move = move;
        const Bought& bought = found[key(wanted)];
        rows.push_back({tracer, text(move), fmt::format("{}", bought.wrong),
                        fmt::format("{:.4f} %", 100.0 * static_cast<double>(bought.wrong) /
                                                    static_cast<double>(bought.compared)),
                        fmt::format("{:.2f}", geometric_mean(bought.ratios))});
    }
    return markdown_table(rows);
}

std::string torture_table(const std::vector<TortureScene>& torture) {
    std::vector<std::string> names;
    for (const TortureScene& scene : torture) {
        for (const auto& [name, counts] : scene.tracers) {
            if (std::ranges::find(names, name) == names.end()) names.push_back(name);
        }
    }
    Rows rows{{"scene", "undecided"}};
    rows[0].insert(rows[0].end(), names.begin(), names.end());
    for (const TortureScene& scene : torture) {
        rows.push_back({scene.name, fmt::format("{}", scene.undecided)});
        for (const std::string& name : names) {
            const auto counts = scene.tracers.find(name);
            if (counts == scene.tracers.end()) {
                rows.back().emplace_back();
                continue;
            }
            const auto& c = counts->second;
            const std::size_t wrong = c.missed + c.phantom + c.moved;
            rows.back().push_back(
                wrong == 0 ? "0"
                           : fmt::format("{} ({}, {}, {})", wrong, c.missed, c.phantom, c.moved));
        }
    }
    return markdown_table(rows);
}

std::string limits_table(const std::vector<PrecisionLimit>& limits) {
    Rows rows{{"zoom"}};
    std::set<double> zooms;
    for (const PrecisionLimit& limit : limits) {
        rows[0].push_back(limit.fractal);
        for (const PrecisionLimit::Step& step : limit.steps) zooms.insert(step.zoom);
    }
    for (const double zoom : zooms) {
        rows.push_back({fmt::format("{:.3g}", zoom)});
        for (const PrecisionLimit& limit : limits) {
            const auto step = std::ranges::find(limit.steps, zoom, &PrecisionLimit::Step::zoom);
            rows.back().push_back(
                step == limit.steps.end() ? "" : fmt::format("{:.1f} %", 100 * step->wrong_share));
        }
    }
    rows.push_back({"good up to"});
    for (const PrecisionLimit& limit : limits) {
        rows.back().push_back(fmt::format("{:.3g}", limit.zoom));
    }
    return markdown_table(rows);
}

}  // namespace

std::string accuracy_page(const Report& report, const std::vector<TortureScene>& torture,
                          const std::vector<PrecisionLimit>& limits) {
    std::string page =
        "# Accuracy\n\n"
        "How wrong each tracer is. What it costs is on [another page](performance.md).\n\n";
    page += run_description(report);
    page += fmt::format(
        "Errors are counted in pictures of {}x{} pixels, against the reference that `zeroset "
        "oracle` computes in double precision with a proof for each pixel; where a scene has "
        "escape-time sets other than those of q^2 + c, from finely stepped estimates. A pixel is "
        "**missed** if there is a "
        "surface and none was found, a **phantom** if one was found where there is none, **moved** "
        "if it is off by more than half a pixel's footprint in depth. Pixels that the reference "
        "could not decide, and those within 0.03 pixel of an outline, do not count.\n\n",
        report.reference_width, report.reference_height);
    page += "## The reference\n\n" + reference_table(report);
    page +=
        "## Wrong pixels\n\nEach tracer with the preset's own settings (missed, phantom, "
        "moved).\n\n" +
        table_of(report, wrong_pixels);
    page +=
        "## Depth error\n\nRelative; 99 % of the pixels that hit and are not moved are "
        "better.\n\n" +
        table_of(report, [](const Errors& e) { return fmt::format("{:.1e}", e.depth_99); });
    page +=
        "## What the settings buy\n\nOver all presets: wrong pixels, and the time as a geometric "
        "mean of its ratio to that with the preset's own settings.\n\n" +
        bought_table(report);
    if (!torture.empty()) {
        page +=
            "## Torture scenes\n\nScenes that aim at one weakness each (`tests/torture/`). The "
            "tests hold every tracer to these numbers of wrong pixels (missed, phantom, moved), "
            "which may only shrink.\n\n" +
            torture_table(torture);
    }
    if (!limits.empty()) {
        page +=
            "## How deep zooms go\n\nWrong pixels in pictures of 40x30 pixels of ever smaller "
            "parts "
            "of the fractals, and the last zoom at which fewer than a quarter are wrong "
            "(`tests/torture/precision_limits.json`).\n\n" +
            limits_table(limits);
    }
    page.pop_back();
    return page;
}

}  // namespace bench
