// SPDX-License-Identifier: MIT
#include "bench/targets.h"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>

#include <fmt/format.h>

#include "bench/generated.h"
#include "bench/markdown.h"
#include "bench/statistics.h"

namespace bench {
namespace {

/// A number of one preset, for finding the worst.
struct Named {
    std::string preset;
    double value = 0;
};

bool is_generated(const PresetReport& preset) { return preset.preset.starts_with("generated/"); }
bool is_fractal(const PresetReport& preset) { return preset.preset.starts_with("fractals/"); }

const PresetReport* preset_of(const Report& report, std::string_view name) {
    const auto found = std::ranges::find(report.presets, name, &PresetReport::preset);
    return found == report.presets.end() ? nullptr : &*found;
}

/// What `value` says of each preset where it says something.
template <class Value>
std::vector<Named> collect(const Report& report, Value value) {
    std::vector<Named> list;
    for (const PresetReport& preset : report.presets) {
        if (is_generated(preset)) continue;
        if (const std::optional<double> number = value(preset)) {
            list.push_back({preset.preset, *number});
        }
    }
    return list;
}

std::optional<double> ratio_to(const PresetReport& preset, std::string_view other) {
    const Entry* entry = find(preset, "auto");
    return entry ? time_ratio(*entry, find(preset, std::string(other))) : std::nullopt;
}

/// All of them at most as much: "41 of 41, at most 2.87 (fractals/mandelbulb)".
Target each_at_most(std::string what, std::string asked, const std::vector<Named>& list,
                    double most, std::string_view unit) {
    Target target{std::move(what), std::move(asked), {}};
    if (list.empty()) return target;
    const auto reached =
        std::ranges::count_if(list, [&](const Named& each) { return each.value <= most; });
    const Named worst = *std::ranges::max_element(list, {}, &Named::value);
    target.reached = fmt::format("{} of {}; at most {:.3g}{} ({})", reached, list.size(),
                                 worst.value, unit, worst.preset);
    target.met = reached == static_cast<std::ptrdiff_t>(list.size());
    return target;
}

Target wrong_pixels(std::string what, double wrong, double compared) {
    constexpr double most = 1.0 / 20'000;
    Target target{std::move(what), "1 in 20,000", {}};
    if (!(compared > 0)) return target;
    target.reached = fmt::format("{:.2f} in 20,000 ({:.0f} of {:.0f})", 20'000 * wrong / compared,
                                 wrong, compared);
    target.met = wrong <= most * compared;
    return target;
}

Target wrong_in_presets(const Report& report) {
    double wrong = 0, compared = 0;
    for (const PresetReport& preset : report.presets) {
        const Entry* entry = preset.smooth ? find(preset, "auto") : nullptr;
        if (!entry || !entry->errors) continue;
        wrong += static_cast<double>(entry->errors->wrong());
        compared += static_cast<double>(entry->errors->compared);
    }
    return wrong_pixels("wrong pixels, smooth presets", wrong, compared);
}

Target wrong_in_torture(const std::vector<TortureScene>& torture) {
    double wrong = 0, compared = 0;
    for (const TortureScene& scene : torture) {
        const auto found = scene.tracers.find("auto");
        if (!scene.smooth || found == scene.tracers.end()) continue;
        const TortureScene::Counts& counts = found->second;
        wrong += static_cast<double>(counts.missed + counts.phantom + counts.moved);
        compared += static_cast<double>(scene.compared);
    }
    return wrong_pixels("wrong pixels, smooth torture scenes", wrong, compared);
}

Target first_order(const Report& report) {
    Target target{"time to plain first-order, smooth presets (geometric mean)", "1", {}};
    std::vector<double> ratios;
    for (const Named& each : collect(report, [](const PresetReport& preset) {
             return preset.smooth ? ratio_to(preset, plain_first_order_name) : std::nullopt;
         })) {
        ratios.push_back(each.value);
    }
    if (ratios.empty()) return target;
    const double mean = geometric_mean(ratios);
    target.reached = fmt::format("{:.2f} over {}", mean, ratios.size());
    target.met = mean <= 1;
    return target;
}

Target stiff(const Report& report) {
    constexpr std::array names{"algebraic/barth_sextic", "surfaces/heart",
                               "algebraic/chmutov_sextic", "algebraic/chmutov_octic",
                               "algebraic/four_windows"};
    const auto list = collect(report, [&](const PresetReport& preset) -> std::optional<double> {
        const bool listed = std::ranges::any_of(
            names, [&](std::string_view name) { return preset.preset.ends_with(name); });
        return listed ? ratio_to(preset, plain_sphere_name) : std::nullopt;
    });
    return each_at_most("time to plain sphere, stiff formulas", "0.1", list, 0.1, "");
}

/// Time to the shader by hand, and a depth error that is no larger.
Target fractal(const Report& report, const std::string& name) {
    Target target{"time to plain, " + name, "0.2, depth error no larger", {}};
    const PresetReport* preset = preset_of(report, name);
    const Entry* entry = preset ? find(*preset, "auto") : nullptr;
    const Entry* plain = preset ? find(*preset, std::string(plain_name)) : nullptr;
    const auto ratio = entry ? time_ratio(*entry, plain) : std::nullopt;
    if (!ratio) return target;
    target.reached = fmt::format("{:.2f}", *ratio);
    target.met = *ratio <= 0.2;
    if (!entry->errors || !plain->errors) return target;
    target.reached +=
        fmt::format(", {:.1e} against {:.1e}", entry->errors->depth_99, plain->errors->depth_99);
    target.met = *target.met && entry->errors->depth_99 <= plain->errors->depth_99;
    return target;
}

Target menger(const Report& report) {
    Target target{"time of fractals/menger_sponge", "0.2 of plain, or 1.5 of the limit", {}};
    const PresetReport* preset = preset_of(report, "fractals/menger_sponge");
    const auto plain = preset ? ratio_to(*preset, plain_name) : std::nullopt;
    const auto limit = preset ? ratio_to(*preset, limit_name) : std::nullopt;
    if (!plain || !limit) return target;
    target.reached = fmt::format("{:.2f} of plain, {:.2f} of the limit", *plain, *limit);
    target.met = *plain <= 0.2 || *limit <= 1.5;
    return target;
}

Target growth(const Report& report) {
    Target target{"time of 1,000 primitives to that of 10", "3", {}};
    const auto seconds = [&](std::string_view name) -> std::optional<double> {
        const PresetReport* preset = preset_of(report, name);
        const Entry* entry = preset ? find(*preset, "auto") : nullptr;
        if (!entry) return std::nullopt;
        return quantile(entry->seconds, 0.5);
    };
    const auto share = [&](std::string_view name) {
        const Entry& entry = *find(*preset_of(report, name), "auto");
        return static_cast<double>(entry.hit) /
               static_cast<double>(std::max<std::size_t>(entry.hit + entry.miss, 1));
    };
    const auto few = seconds(few_name), many = seconds(many_name);
    if (!few || !many) return target;
    target.reached = fmt::format("{:.2f} ({:.0f} % and {:.0f} % of the picture are covered)",
                                 *many / *few, 100 * share(many_name), 100 * share(few_name));
    // A smaller picture would be no answer.
    target.met = *many <= 3 * *few && share(many_name) >= 0.95 * share(few_name);
    return target;
}

std::optional<double> first_picture(const PresetReport& preset) {
    const Entry* entry = find(preset, "auto");
    if (!entry) return std::nullopt;
    return 1e3 * (preset.parse_seconds + preset.analyse_seconds + entry->link_seconds +
                  entry->first_frame_seconds);
}

Target text_to_picture(const Report& report, bool fractals) {
    const double most = fractals ? 400 : 150;
    Target target = each_at_most(
        fmt::format("from text to picture, {}", fractals ? "fractals" : "formulas"),
        fmt::format("{} ms, without a cache of shaders", most),
        collect(report,
                [&](const PresetReport& preset) {
                    return is_fractal(preset) == fractals ? first_picture(preset) : std::nullopt;
                }),
        most, " ms");
    // What a driver takes from its disk says nothing of a text that was just typed.
    if (report.machine.shader_cache) {
        if (!target.reached.empty()) target.reached += ", with such a cache";
        target.met.reset();
    }
    return target;
}

/// A slider must not be felt: what comes before its picture is drawn takes less than a frame.
Target slider(const Report& report) {
    constexpr double most = 1e3 / 60;
    std::vector<Named> before;
    Named longest;
    for (const PresetReport& preset : report.presets) {
        if (!preset.slider) continue;
        before.push_back({preset.preset, 1e3 * preset.slider->before_seconds});
        const double whole = 1e3 * preset.slider->picture_seconds;
        if (whole > longest.value) longest = {preset.preset, whole};
    }
    Target target =
        each_at_most("from a slider's move to drawing", "16.7 ms, a frame", before, most, " ms");
    if (before.empty()) return target;
    target.reached +=
        fmt::format("; to the picture at most {:.3g} ms ({})", longest.value, longest.preset);
    return target;
}

}  // namespace

std::vector<Target> targets(const Report& report, const std::vector<TortureScene>& torture) {
    return {wrong_in_presets(report),
            wrong_in_torture(torture),
            first_order(report),
            stiff(report),
            fractal(report, "fractals/mandelbulb"),
            fractal(report, "fractals/julia_default"),
            menger(report),
            each_at_most(
                "time to the limit, each preset", "3",
                collect(report,
                        [](const PresetReport& preset) { return ratio_to(preset, limit_name); }),
                3, ""),
            growth(report),
            each_at_most("analysis of each preset", "15 ms",
                         collect(report,
                                 [](const PresetReport& preset) {
                                     return std::optional(1e3 * preset.analyse_seconds);
                                 }),
                         15, " ms"),
            text_to_picture(report, false),
            text_to_picture(report, true),
            slider(report)};
}

std::string targets_table(const std::vector<Target>& targets) {
    std::vector<std::vector<std::string>> rows{{"what", "asked, at most", "measured", "reached"}};
    for (const Target& target : targets) {
        rows.push_back({target.what, target.asked,
                        target.reached.empty() ? "not measured" : target.reached,
                        !target.met   ? ""
                        : *target.met ? "yes"
                                      : "no"});
    }
    return markdown_table(rows);
}

}  // namespace bench
