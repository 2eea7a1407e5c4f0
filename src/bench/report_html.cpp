// SPDX-License-Identifier: MIT
#include "bench/report_html.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "bench/plot.h"
#include "bench/statistics.h"
#include "image/png.h"

namespace bench {
namespace {

constexpr std::string_view style = R"(
body { font: 15px/1.45 system-ui, sans-serif; margin: 2em auto; max-width: 75em; padding: 0 1em;
       color: #222; background: #fff; }
h1, h2 { font-weight: 600; } h2 { margin-top: 2.2em; border-top: 1px solid #ccc; padding-top: .8em; }
table { border-collapse: collapse; font-size: 13px; margin: 1em 0; }
th, td { padding: .15em .7em; text-align: right; border-bottom: 1px solid #e4e4e4; }
th:nth-child(-n+2), td:nth-child(-n+2) { text-align: left; }
th { font-weight: 600; border-bottom: 1px solid #888; }
tr.own td { background: #f3f6fa; }
svg { max-width: 100%; height: auto; font: 12px system-ui, sans-serif; }
.grid { stroke: #ddd; } .front { fill: none; stroke: #222; stroke-width: 1.6; }
.pictures { display: flex; flex-wrap: wrap; gap: 1em; }
figure { margin: 0; } figcaption { font-size: 13px; }
img { image-rendering: pixelated; width: 20em; }
)";

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            bits =
                bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            text += i + k <= bytes.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
        }
    }
    return text;
}

std::string ratio(const Entry& entry, const Entry* other) {
    const auto value = time_ratio(entry, other);
    return value ? fmt::format("{:.2f}", *value) : "";
}

std::string error_cells(const std::optional<Errors>& e) {
    if (!e) return "<td></td><td></td><td></td><td></td><td></td>";
    return fmt::format("<td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{:.1e}</td>", e->wrong(),
                       e->missed, e->phantom, e->moved, e->depth_99);
}

std::string share_cell(const std::optional<Passes>& passes) {
    if (!passes) return "<td></td>";
    const auto s = shares(*passes);
    return fmt::format("<td>{:.0f} / {:.0f} / {:.0f} / {:.0f} %</td>", 100 * s[0], 100 * s[1],
                       100 * s[2], 100 * s[3]);
}

std::string table(const PresetReport& preset) {
    std::string html =
        "<table><tr><th>tracer</th><th>setting</th><th>ms</th><th>quartiles</th><th>to plain</th>"
        "<th>to limit</th><th>evaluations a pixel</th><th>unresolved</th><th>wrong</th>"
        "<th>missed</th><th>phantom</th><th>moved</th><th>depth error, 99 %</th>"
        "<th>geometry / normal / light / shadow</th><th>link ms</th><th>first ms</th></tr>\n";
    const Entry* plain = plain_of(preset);
    const Entry* limit = find(preset, std::string(limit_name));
    for (const Entry& e : preset.entries) {
        const Quartiles q = quartiles(e.seconds);
        const bool own = e.move.name.empty();
        html += fmt::format(
            "<tr{}><td>{}</td><td>{}</td><td>{:.2f}</td><td>{:.2f}-{:.2f}</td><td>{}</td><td>{}"
            "</td><td>{}</td><td>{}</td>{}{}<td>{}</td><td>{}</td></tr>\n",
            own ? " class='own'" : "", escaped(e.tracer), escaped(text(e.move)), 1e3 * q.median,
            1e3 * q.lower, 1e3 * q.upper, ratio(e, plain), ratio(e, limit),
            e.evaluations ? fmt::format("{:.1f}", *e.evaluations) : "", e.unresolved,
            error_cells(e.errors), share_cell(e.passes),
            own ? fmt::format("{:.0f}", 1e3 * e.link_seconds) : "",
            own ? fmt::format("{:.0f}", 1e3 * e.first_frame_seconds) : "");
    }
    return html + "</table>\n";
}

void add(Curve& curve, const Entry& entry) {
    const Errors& e = *entry.errors;
    const double part =
        static_cast<double>(e.wrong()) / static_cast<double>(std::max<std::size_t>(e.compared, 1));
    curve.trades.push_back({quantile(entry.seconds, 0.5), part});
    curve.labels.push_back(text(entry.move));
}

/// The entries of a tracer that move one setting, and its own, in the order of the values.
Curve curve_of(const PresetReport& preset, const Entry& own, const std::string& setting) {
    std::vector<std::pair<double, const Entry*>> list{{preset.settings.at(setting), &own}};
    for (const Entry& e : preset.entries) {
        if (e.tracer == own.tracer && e.move.name == setting && e.errors) {
            list.emplace_back(e.move.value, &e);
        }
    }
    std::ranges::stable_sort(list, {}, &std::pair<double, const Entry*>::first);
    Curve curve{own.tracer, setting, {}, {}};
    for (const auto& [value, entry] : list) add(curve, *entry);
    return curve;
}

/// For each tracer and each setting that is moved a curve through the preset's own.
std::vector<Curve> curves(const PresetReport& preset) {
    std::vector<Curve> list;
    for (const Entry& own : preset.entries) {
        if (!own.move.name.empty() || !own.errors) continue;
        const std::size_t before = list.size();
        for (const auto& [setting, value] : preset.settings) {
            Curve curve = curve_of(preset, own, setting);
            if (curve.trades.size() > 1) list.push_back(std::move(curve));
        }
        if (list.size() > before) continue;
        list.push_back({own.tracer, "", {}, {}});
        add(list.back(), own);
    }
    return list;
}

std::string figures(const PresetReport& preset, const std::vector<MarkedPicture>& pictures) {
    std::string html;
    for (const MarkedPicture& marked : pictures) {
        const Entry* entry = find(preset, marked.tracer);
        if (!entry || !entry->errors || entry->errors->wrong() == 0) continue;
        const auto png = image::encode_png(marked.picture);
        if (!png) continue;
        html += fmt::format(
            "<figure><img alt='' src='data:image/png;base64,{}'/><figcaption>{}: {} wrong of {}"
            "</figcaption></figure>\n",
            base64(*png), escaped(marked.tracer), entry->errors->wrong(), entry->errors->compared);
    }
    return html.empty() ? "" : "<div class='pictures'>\n" + html + "</div>\n";
}

std::string head(const Report& report) {
    const Machine& m = report.machine;
    std::string html = fmt::format(
        "<h1>Run time against error</h1>\n<p>{}, {} cores; {}; {}; {}{}{}<br/>{}x{} pixels, {} "
        "rounds; every configuration of a preset was drawn once a round, in another order each "
        "round.<br/><code>{}</code></p>\n",
        escaped(m.processor), m.cores, escaped(m.renderer), escaped(m.version), escaped(m.date),
        m.commit.empty() ? "" : "; commit " + escaped(m.commit),
        m.shader_cache ? "" : "; without a cache of shaders", report.width, report.height,
        report.rounds, escaped(report.command));
    if (report.reference_width > 0) {
        html += fmt::format(
            "<p>Errors are those of pictures of {}x{} pixels against the reference, without pixels "
            "that it could not decide or that are within 0.03 pixel of an outline. In pictures "
            "missed pixels are red, phantoms blue, moved ones yellow, those that do not count "
            "violet. In plots the dashed curves move epsilon.</p>\n",
            report.reference_width, report.reference_height);
    }
    return html;
}

}  // namespace

std::string report_html(const Report& report,
                        const std::vector<std::vector<MarkedPicture>>& pictures) {
    std::string html = fmt::format(
        "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'/><title>Run time against "
        "error</title>\n<style>{}</style></head><body>\n{}",
        style, head(report));
    for (std::size_t i = 0; i < report.presets.size(); ++i) {
        const PresetReport& preset = report.presets[i];
        html += fmt::format("<h2>{}</h2>\n", escaped(preset.preset));
        const auto list = curves(preset);
        if (!list.empty()) {
            const double pixels =
                static_cast<double>(report.reference_width) * std::max(report.reference_height, 1);
            html += svg_plot(list, 0.5 / pixels);
        }
        html += table(preset);
        if (i < pictures.size()) html += figures(preset, pictures[i]);
    }
    return html + "</body></html>\n";
}

}  // namespace bench
