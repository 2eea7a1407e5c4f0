// SPDX-License-Identifier: MIT
#include "bench/report_csv.h"

#include <fmt/format.h>

#include "bench/statistics.h"

namespace bench {
namespace {

std::string ratio(const Entry& entry, const Entry* other) {
    const auto value = time_ratio(entry, other);
    return value ? fmt::format("{:.6g}", *value) : "";
}

std::string errors(const std::optional<Errors>& e) {
    if (!e) return ",,,,,,,,,";
    return fmt::format("{},{},{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g}", e->compared, e->undecided,
                       e->fragile, e->missed, e->phantom, e->moved, e->depth_median, e->depth_99,
                       e->depth_largest, e->normal_99);
}

std::string passes(const std::optional<Passes>& p) {
    if (!p) return ",,,";
    const auto s = shares(*p);
    return fmt::format("{:.6g},{:.6g},{:.6g},{:.6g}", s[0], s[1], s[2], s[3]);
}

}  // namespace

std::string report_csv(const Report& report) {
    std::string text =
        "preset,tracer,setting,value,seconds,seconds_lower_quartile,seconds_upper_quartile,"
        "ratio_to_plain,ratio_to_limit,link_seconds,first_frame_seconds,evaluations_a_pixel,"
        "hit,miss,unresolved,compared,undecided,fragile,missed,phantom,moved,depth_median,"
        "depth_99,depth_largest,normal_99,geometry_share,normal_share,light_share,shadow_share\n";
    for (const PresetReport& preset : report.presets) {
        const Entry* plain = plain_of(preset);
        const Entry* limit = find(preset, std::string(limit_name));
        for (const Entry& e : preset.entries) {
            const Quartiles q = quartiles(e.seconds);
            text += fmt::format(
                "{},{},{},{},{:.6g},{:.6g},{:.6g},{},{},{:.6g},{:.6g},{},{},{},{},{},{}\n",
                preset.preset, e.tracer, e.move.name,
                e.move.name.empty() ? "" : fmt::format("{}", e.move.value), q.median, q.lower,
                q.upper, ratio(e, plain), ratio(e, limit), e.link_seconds, e.first_frame_seconds,
                e.evaluations ? fmt::format("{:.6g}", *e.evaluations) : "", e.hit, e.miss,
                e.unresolved, errors(e.errors), passes(e.passes));
        }
    }
    return text;
}

}  // namespace bench
