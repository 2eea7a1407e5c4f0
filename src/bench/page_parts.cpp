// SPDX-License-Identifier: MIT
#include "bench/page_parts.h"

#include <algorithm>

#include <fmt/format.h>

namespace bench {

std::string run_description(const Report& report) {
    const Machine& m = report.machine;
    return fmt::format(
        "This page is generated. To make it again, with the tables of "
        "accuracy:\n\n```\n{}{}\n```\n\n"
        "{}, {} cores; {}; {}; {}{}. Pictures of {}x{} pixels, {} rounds: in each round every "
        "configuration of a preset draws one frame, in another order each time.\n\n",
        m.shader_cache ? "" : "MESA_SHADER_CACHE_DISABLE=true ", report.command, m.processor,
        m.cores, m.renderer, m.version, m.date, m.commit.empty() ? "" : "; commit " + m.commit,
        report.width, report.height, report.rounds);
}

std::vector<std::string> tracer_names(const Report& report) {
    std::vector<std::string> names;
    for (const PresetReport& preset : report.presets) {
        for (const Entry& entry : preset.entries) {
            const bool is_other =
                entry.tracer.starts_with(plain_name) || entry.tracer == limit_name;
            if (!is_other && std::ranges::find(names, entry.tracer) == names.end()) {
                names.push_back(entry.tracer);
            }
        }
    }
    return names;
}

}  // namespace bench
