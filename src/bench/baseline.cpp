// SPDX-License-Identifier: MIT
#include "bench/baseline.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace bench {
namespace {

constexpr double confidence = 0.998;
constexpr double least_change = 0.08;
constexpr std::uint32_t seed = 1;

/// By round.
std::vector<double> in_yardsticks(const PresetReport& preset, const Entry& entry) {
    std::vector<double> list;
    const std::size_t both = std::min(preset.yardstick_seconds.size(), entry.seconds.size());
    for (std::size_t i = 0; i < both; ++i) {
        list.push_back(entry.seconds[i] / preset.yardstick_seconds[i]);
    }
    return list;
}

Change change(const PresetReport& before, const Entry& old, const PresetReport& now,
              const Entry& entry, bool same_reference) {
    Change c;
    c.preset = now.preset;
    c.tracer = entry.tracer;
    c.move = entry.move;
    const auto a = in_yardsticks(before, old), b = in_yardsticks(now, entry);
    if (!a.empty() && !b.empty()) {
        c.ratio = quantile(b, 0.5) / quantile(a, 0.5);
        c.interval = ratio_of_medians(a, b, confidence, seed);
        const Quartiles qa = quartiles(a), qb = quartiles(b);
        const bool apart = qb.lower > qa.upper || qb.upper < qa.lower;
        c.speed = apart ? speed(c.interval) : Speed::same;
    }
    if (old.errors && entry.errors && same_reference) {
        c.wrong_before = old.errors->wrong();
        c.wrong_now = entry.errors->wrong();
        c.accuracy = accuracy(c.wrong_before, c.wrong_now);
    }
    return c;
}

std::string line(const Change& c) {
    std::string text = fmt::format("{}, {}, {}:", c.preset, c.tracer, bench::text(c.move));
    if (c.speed != Speed::same) {
        text += fmt::format(" {} ({:.2f} times the time, {:.2f} to {:.2f})",
                            c.speed == Speed::faster ? "faster" : "slower", c.ratio, c.interval.low,
                            c.interval.high);
    }
    if (c.accuracy == Accuracy::better || c.accuracy == Accuracy::worse) {
        text +=
            fmt::format("{} {} ({} wrong pixels instead of {})", c.speed == Speed::same ? "" : ",",
                        c.accuracy == Accuracy::better ? "less wrong" : "more wrong", c.wrong_now,
                        c.wrong_before);
    }
    return text + '\n';
}

bool is_noise(const Change& c) {
    return c.speed == Speed::same && c.accuracy != Accuracy::better &&
           c.accuracy != Accuracy::worse;
}

}  // namespace

Speed speed(const Interval& interval) {
    if (interval.low > 1 + least_change) return Speed::slower;
    if (interval.high < 1 / (1 + least_change)) return Speed::faster;
    return Speed::same;
}

Accuracy accuracy(std::size_t wrong_before, std::size_t wrong_now) {
    const auto before = static_cast<double>(wrong_before), now = static_cast<double>(wrong_now);
    if (std::abs(now - before) <= 2 * std::sqrt(std::max(before, now))) return Accuracy::same;
    return now < before ? Accuracy::better : Accuracy::worse;
}

base::Result<std::vector<Change>> changes(const Report& before, const Report& now) {
    if (before.width != now.width || before.height != now.height) {
        return base::error(fmt::format(
            "the baseline was drawn with {}x{} pixels; measure with --size {}x{} to compare",
            before.width, before.height, before.width, before.height));
    }
    const bool same_reference = before.reference_width == now.reference_width &&
                                before.reference_height == now.reference_height;
    std::vector<Change> list;
    for (const PresetReport& preset : now.presets) {
        const auto old = std::ranges::find(before.presets, preset.preset, &PresetReport::preset);
        if (old == before.presets.end()) continue;
        for (const Entry& entry : preset.entries) {
            const Entry* old_entry = find(*old, entry.tracer, entry.move);
            if (old_entry) list.push_back(change(*old, *old_entry, preset, entry, same_reference));
        }
    }
    return list;
}

bool has_regression(const std::vector<Change>& changes) {
    return std::ranges::any_of(changes, [](const Change& c) {
        return c.speed == Speed::slower || c.accuracy == Accuracy::worse;
    });
}

std::string changes_text(const std::vector<Change>& changes) {
    std::string text;
    std::size_t same = 0;
    std::vector<double> ratios;
    for (const Change& c : changes) {
        if (c.interval.low > 0) ratios.push_back(c.ratio);
        if (is_noise(c)) {
            ++same;
        } else {
            text += line(c);
        }
    }
    text +=
        fmt::format("{} of {} configurations are the same, within the noise", same, changes.size());
    if (!ratios.empty()) {
        text += fmt::format("; all take {:.3f} times the time, by the geometric mean",
                            geometric_mean(ratios));
    }
    return text + '\n';
}

}  // namespace bench
