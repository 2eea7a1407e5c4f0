// SPDX-License-Identifier: MIT
#include "bench/report_text.h"

#include <fmt/format.h>

#include "bench/statistics.h"

namespace bench {
namespace {

std::string ratio(const Entry& entry, const Entry* other) {
    const auto value = time_ratio(entry, other);
    return value ? fmt::format("{:.2f}", *value) : "-";
}

std::string errors(const Entry& entry) {
    if (!entry.errors) return fmt::format("{:>8} {:>9}", "-", "-");
    return fmt::format("{:>8} {:>9.1e}", entry.errors->wrong(), entry.errors->depth_99);
}

std::string passes(const Entry& entry) {
    if (!entry.passes) return "";
    const auto parts = shares(*entry.passes);
    return fmt::format("  {:.0f} {:.0f} {:.0f} {:.0f} %", 100 * parts[0], 100 * parts[1],
                       100 * parts[2], 100 * parts[3]);
}

}  // namespace

std::string machine_text(const Report& report) {
    const Machine& m = report.machine;
    return fmt::format(
        "{}, {} cores; {}; {}; {}; {}{}\n"
        "{}x{} pixels, {} rounds; every configuration of a preset is drawn once a round\n",
        m.processor, m.cores, m.renderer, m.version, m.date,
        m.commit.empty() ? "no commit" : "commit " + m.commit,
        m.shader_cache ? "" : "; no cache of shaders", report.width, report.height, report.rounds);
}

std::string preset_text(const PresetReport& preset) {
    std::string text = fmt::format(
        "\n{}\n{:<18} {:<14} {:>8} {:>15} {:>7} {:>7} {:>8} {:>8} {:>8} {:>9} {:>7}  {}\n",
        preset.preset, "tracer", "setting", "ms", "quartiles", "/plain", "/limit", "evals/px",
        "unres.", "wrong", "depth 99%", "first", "geometry normal light shadow");
    const Entry* plain = plain_of(preset);
    const Entry* limit = find(preset, std::string(limit_name));
    for (const Entry& entry : preset.entries) {
        const Quartiles q = quartiles(entry.seconds);
        text += fmt::format(
            "{:<18} {:<14} {:>8.2f} {:>15} {:>7} {:>7} {:>8} {:>8} {} {:>7}{}\n", entry.tracer,
            bench::text(entry.move), 1e3 * q.median,
            fmt::format("{:.2f}-{:.2f}", 1e3 * q.lower, 1e3 * q.upper), ratio(entry, plain),
            ratio(entry, limit),
            entry.evaluations ? fmt::format("{:.1f}", *entry.evaluations) : "-", entry.unresolved,
            errors(entry),
            entry.move.name.empty() ? fmt::format("{:.0f}", 1e3 * entry.first_frame_seconds) : "",
            passes(entry));
    }
    return text;
}

}  // namespace bench
