// SPDX-License-Identifier: MIT
#include "bench/report.h"

#include <algorithm>

#include "bench/statistics.h"

namespace bench {

std::array<double, 4> shares(const Passes& passes) {
    const double normal = std::max(passes.normal, passes.geometry);
    const double shading = std::max(passes.shading, normal);
    const double whole = std::max(passes.shadows, shading);
    if (whole <= 0) return {};
    return {passes.geometry / whole, (normal - passes.geometry) / whole, (shading - normal) / whole,
            (whole - shading) / whole};
}

const Entry* find(const PresetReport& preset, const std::string& tracer, const Move& move) {
    const auto entry = std::ranges::find_if(
        preset.entries, [&](const Entry& e) { return e.tracer == tracer && e.move == move; });
    return entry == preset.entries.end() ? nullptr : &*entry;
}

std::optional<double> time_ratio(const Entry& entry, const Entry* other) {
    if (!other) return std::nullopt;
    const std::size_t both = std::min(entry.seconds.size(), other->seconds.size());
    if (both == 0) return std::nullopt;
    const std::span<const double> a(entry.seconds), b(other->seconds);
    return paired_ratio(a.first(both), b.first(both)).median;
}

const Entry* plain_of(const PresetReport& preset) {
    const Entry* own = find(preset, std::string(plain_name));
    return own ? own : find(preset, std::string(plain_sphere_name));
}

}  // namespace bench
