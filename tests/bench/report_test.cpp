// SPDX-License-Identifier: MIT
// What is written of a report, and read again.
#include "bench/report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <sstream>
#include <vector>

#include "bench/generated.h"
#include "bench/hand_made.h"
#include "bench/markdown.h"
#include "bench/pages.h"
#include "bench/plot.h"
#include "bench/report_csv.h"
#include "bench/report_html.h"
#include "bench/report_json.h"
#include "bench/report_text.h"
#include "bench/targets.h"

namespace bench {
namespace {

bool has(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

TEST(Report, ratios_are_by_rounds) {
    const PresetReport preset = hand_made().presets[0];
    const Entry& own = preset.entries[0];
    EXPECT_DOUBLE_EQ(*time_ratio(own, plain_of(preset)), 0.5);
    EXPECT_DOUBLE_EQ(*time_ratio(own, find(preset, "limit")), 4);
    EXPECT_FALSE(time_ratio(own, nullptr));
    Entry slow = own;
    slow.seconds = {16e-3};
    EXPECT_DOUBLE_EQ(*time_ratio(slow, find(preset, "limit")), 16);
    slow.seconds.clear();
    EXPECT_FALSE(time_ratio(slow, find(preset, "limit")));
    EXPECT_FALSE(time_ratio(own, find(preset, "nobody")));
}

TEST(ReportJson, comes_back_as_it_was) {
    Report report = hand_made();
    report.presets[0].slider = SliderMove{0.004, 0.03, true};
    const std::string text = report_json(report);
    const auto read = read_report(text, "a.json");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->presets, report.presets);
    EXPECT_EQ(report_json(*read), text);
    EXPECT_EQ(read->machine.processor, report.machine.processor);
}

TEST(ReportJson, refuses_what_is_no_report) {
    for (const char* text : {"", "{}", "[1]", R"({"zeroset_bench": 1, "machine": 3})"}) {
        const auto read = read_report(text, "a.json");
        ASSERT_FALSE(read);
        EXPECT_EQ(read.problems()[0].message,
                  "'a.json' is no report; make one with 'zeroset bench --json'");
    }
    EXPECT_EQ(read_report(R"({"zeroset_bench": 2})", "a.json").problems()[0].message,
              "'a.json' is a report of another version; make it again with 'zeroset bench --json'");
}

TEST(ReportCsv, has_as_many_cells_in_each_line) {
    std::istringstream text(report_csv(hand_made()));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    ASSERT_EQ(lines.size(), 7U);
    for (const std::string& line : lines) {
        EXPECT_EQ(std::ranges::count(line, ','), std::ranges::count(lines[0], ',')) << line;
    }
    EXPECT_TRUE(lines[1].starts_with("surfaces/ball,auto,,,0.004,0.004,0.006,0.5,4,"));
    EXPECT_TRUE(lines[2].starts_with("surfaces/ball,auto,lipschitz,2,0.006,"));
    EXPECT_TRUE(lines[1].ends_with(",0.25,0.25,0.25,0.25"));
}

TEST(ReportText, has_a_line_for_each_entry) {
    const std::string text = preset_text(hand_made().presets[0]);
    EXPECT_EQ(std::ranges::count(text, '\n'), 3 + 6);
    EXPECT_TRUE(has(text, "25 25 25 25 %"));
    EXPECT_TRUE(has(machine_text(hand_made()), "driver & co"));
}

/// Whether every element that is opened is closed, in the right order, as XML wants it.
bool is_well_formed(const std::string& html) {
    std::vector<std::string> open;
    const std::regex tag("<(/?)([a-zA-Z0-9]+)((?:[^<>'\"]|'[^']*'|\"[^\"]*\")*?)(/?)>");
    std::string rest = html.substr(html.find('\n') + 1);  // behind the document type
    const std::size_t style = rest.find("<style>"), end = rest.find("</style>");
    rest.erase(style, end + 8 - style);
    std::size_t marks = 0;
    for (std::sregex_iterator it(rest.begin(), rest.end(), tag), last; it != last; ++it) {
        ++marks;
        const std::smatch& m = *it;
        if (m[1].length()) {
            if (open.empty() || open.back() != m[2]) return false;
            open.pop_back();
        } else if (!m[4].length() && m[2] != "meta") {
            open.push_back(m[2]);
        }
    }
    return open.empty() && marks == static_cast<std::size_t>(std::ranges::count(rest, '<')) &&
           marks == static_cast<std::size_t>(std::ranges::count(rest, '>'));
}

MarkedPicture red() {
    MarkedPicture marked{"auto", image::Picture(3, 2)};
    marked.picture.values[0] = 255;
    return marked;
}

TEST(ReportHtml, is_well_formed_and_needs_nothing_from_elsewhere) {
    Report report = hand_made();
    report.presets[0].preset = "<b>'&\"";
    const std::string html = report_html(report, {{red()}});
    EXPECT_TRUE(is_well_formed(html));
    for (const char* part : {"http:", "https:", "//", "<script", "@import", "url(", "<b>"}) {
        EXPECT_FALSE(has(html, part)) << part;
    }
    EXPECT_TRUE(has(html, "A processor &lt;fast&gt;"));
    EXPECT_TRUE(has(html, "data:image/png;base64,iVBORw0KGgo"));
    EXPECT_FALSE(is_well_formed("<!DOCTYPE html>\n<p><style></style><b></p></b>"));
}

TEST(ReportHtml, shows_pictures_only_where_something_is_wrong) {
    Report report = hand_made();
    report.presets[0].entries[0].errors->phantom = 0;
    EXPECT_FALSE(has(report_html(report, {{red()}}), "<img"));
    EXPECT_FALSE(has(report_html(hand_made(), {}), "<img"));
}

TEST(Plot, has_a_mark_for_each_trade_and_a_ring_around_those_on_the_front) {
    const std::vector<Curve> curves{{"a", "lipschitz", {{1e-3, 0.1}, {2e-3, 0.01}}, {"1", "2"}},
                                    {"b", "", {{4e-3, 0.05}}, {"1"}}};
    const std::string svg = svg_plot(curves, 1e-4);
    const auto count = [&](const std::string& part) {
        std::size_t number = 0;
        for (std::size_t at = svg.find(part); at != std::string::npos;
             at = svg.find(part, at + 1)) {
            ++number;
        }
        return number;
    };
    EXPECT_EQ(count("<title>"), 3U);
    EXPECT_EQ(count("class='front'"), 2U + 1);  // and one in the legend
    EXPECT_EQ(count("<polyline"), 2U);
    EXPECT_TRUE(has(svg, "<title>b, 1: 4.00 ms, 5.0000 % wrong</title>"));
    EXPECT_FALSE(has(svg, "nan"));
    EXPECT_FALSE(has(svg_plot({}, 1e-4), "nan"));
}

TEST(Plot, puts_no_error_on_the_lowest_line) {
    const std::vector<Curve> curves{{"a", "", {{1e-3, 0}}, {"1"}}};
    EXPECT_TRUE(has(svg_plot(curves, 1e-4), "cy='300.0' r='3.6'"));
}

TEST(Markdown, is_a_table) {
    EXPECT_EQ(markdown_table({{"a", "b"}, {"1", "2"}}), "| a | b |\n| --- | ---: |\n| 1 | 2 |\n\n");
    EXPECT_EQ(markdown_table({{"a", "b"}}), "");
}

TEST(Pages, hold_the_numbers_of_the_run) {
    const Report report = hand_made();
    const std::string performance = performance_page(report, {});
    EXPECT_TRUE(has(performance, "| auto |  | 0.50 (1) |  | 4.00 (1) |"));
    EXPECT_TRUE(has(performance, "| surfaces/ball | 4.00 | 10.00 |  | 8.00 |  | 1.00 |"));
    EXPECT_TRUE(has(performance, "| surfaces/ball | auto | 25 % | 25 % | 25 % | 25 % |"));
    EXPECT_TRUE(has(performance, "```\nzeroset bench\n```"));
    Report cold = report;
    cold.machine.shader_cache = false;
    EXPECT_TRUE(
        has(performance_page(cold, {}), "```\nMESA_SHADER_CACHE_DISABLE=true zeroset bench\n```"));
    const std::string accuracy = accuracy_page(report, {}, {});
    EXPECT_TRUE(has(accuracy, "| surfaces/ball | 2 (0, 2, 0) | 0 |  | 50 (0, 50, 0) |  |"));
    EXPECT_TRUE(has(accuracy, "| auto | lipschitz 2 | 1 | 1.0000 % | 1.50 |"));
    EXPECT_FALSE(has(accuracy, "Torture"));
    for (const std::string& page : {performance, accuracy}) {
        EXPECT_FALSE(has(page, "nan"));
        EXPECT_FALSE(page.ends_with("\n\n"));
    }
}

/// What was measured of a target, and whether it was met.
std::string reached(const Report& report, const std::vector<TortureScene>& torture,
                    const std::string& what) {
    for (const Target& target : targets(report, torture)) {
        if (target.what != what) continue;
        return target.reached + (!target.met ? "" : *target.met ? ": yes" : ": no");
    }
    return "there is no such target";
}

TEST(Targets, are_held_against_the_run) {
    Report report = hand_made();
    EXPECT_EQ(reached(report, {}, "wrong pixels, smooth presets"),
              "400.00 in 20,000 (2 of 100): no");
    EXPECT_EQ(reached(report, {}, "time to the limit, each preset"),
              "0 of 1; at most 4 (surfaces/ball): no");
    report.presets[0].entries[0].errors->phantom = 0;
    report.presets[0].entries.back().seconds = {2e-3, 4e-3, 2e-3};
    EXPECT_EQ(reached(report, {}, "wrong pixels, smooth presets"),
              "0.00 in 20,000 (0 of 100): yes");
    EXPECT_EQ(reached(report, {}, "time to the limit, each preset"),
              "1 of 1; at most 2 (surfaces/ball): yes");
    EXPECT_EQ(reached(report, {}, "wrong pixels, smooth torture scenes"), "");
    report.presets[0].parse_seconds = 0.1;
    report.presets[0].analyse_seconds = 0.02;
    report.presets[0].entries[0].link_seconds = 0.01;
    report.presets[0].entries[0].first_frame_seconds = 0.03;
    EXPECT_EQ(reached(report, {}, "analysis of each preset"),
              "0 of 1; at most 20 ms (surfaces/ball): no");
    report.machine.shader_cache = false;
    EXPECT_EQ(reached(report, {}, "from text to picture, formulas"),
              "0 of 1; at most 160 ms (surfaces/ball): no");
    report.machine.shader_cache = true;
    EXPECT_EQ(reached(report, {}, "from text to picture, formulas"),
              "0 of 1; at most 160 ms (surfaces/ball), with such a cache");
    EXPECT_EQ(reached(report, {}, "from text to picture, fractals"), "");
    EXPECT_EQ(reached(report, {}, "from a slider's move to drawing"), "");
    report.presets[0].slider = SliderMove{0.004, 0.03, false};
    EXPECT_EQ(reached(report, {}, "from a slider's move to drawing"),
              "1 of 1; at most 4 ms (surfaces/ball); to the picture at most 30 ms "
              "(surfaces/ball): yes");
    report.presets[0].slider = SliderMove{0.02, 0.03, true};
    EXPECT_EQ(reached(report, {}, "from a slider's move to drawing"),
              "0 of 1; at most 20 ms (surfaces/ball); to the picture at most 30 ms "
              "(surfaces/ball): no");
}

TEST(Targets, compare_fractals_with_the_shaders_by_hand) {
    Report report = hand_made();
    PresetReport fractal = report.presets[0];
    fractal.preset = "fractals/mandelbulb";
    fractal.entries = {entry("auto", {}, {1e-3, 2e-3}, 0), entry("plain", {}, {8e-3, 16e-3}, 0)};
    report.presets.push_back(fractal);
    EXPECT_EQ(reached(report, {}, "time to plain, fractals/mandelbulb"),
              "0.12, 1.0e-06 against 1.0e-06: yes");
    report.presets[1].entries[0].errors->depth_99 = 2e-6;
    EXPECT_EQ(reached(report, {}, "time to plain, fractals/mandelbulb"),
              "0.12, 2.0e-06 against 1.0e-06: no");
}

TEST(Targets, count_smooth_torture_scenes_only) {
    TortureScene smooth{.name = "degree/a", .smooth = true, .compared = 20'000, .tracers = {}};
    smooth.tracers["auto"] = {1, 0, 1, 0};
    TortureScene rough = smooth;
    rough.smooth = false;
    EXPECT_EQ(reached({}, {smooth, rough}, "wrong pixels, smooth torture scenes"),
              "2.00 in 20,000 (2 of 20000): no");
}

TEST(Targets, compare_a_thousand_primitives_with_ten) {
    Report report;
    for (const std::string_view name : {few_name, many_name}) {
        PresetReport preset;
        preset.preset = std::string(name);
        preset.entries = {entry("auto", {}, {name == few_name ? 1e-3 : 2.5e-3}, 0)};
        report.presets.push_back(preset);
    }
    EXPECT_EQ(reached(report, {}, "time of 1,000 primitives to that of 10"),
              "2.50 (30 % and 30 % of the picture are covered): yes");
    // They are no presets.
    EXPECT_EQ(reached(report, {}, "analysis of each preset"), "");
}

TEST(Pages, say_how_deep_zooms_go) {
    const auto limits = read_precision_limits(
        R"({"julia": {"limit": 10000.0, "steps": [{"zoom": 100, "wrong_share": 0.0757},
                                                 {"zoom": 31600.0, "wrong_share": 0.25}]},
            "menger": {"limit": 100.0, "steps": [{"zoom": 100, "wrong_share": 0.5}]}})",
        "limits.json");
    ASSERT_TRUE(limits);
    const std::string page = accuracy_page(hand_made(), {}, *limits);
    EXPECT_TRUE(has(page, "| zoom | julia | menger |"));
    EXPECT_TRUE(has(page, "| 100 | 7.6 % | 50.0 % |"));
    EXPECT_TRUE(has(page, "| 3.16e+04 | 25.0 % |  |"));
    EXPECT_TRUE(has(page, "| good up to | 1e+04 | 100 |"));
    EXPECT_EQ(read_precision_limits("[1]", "limits.json").problems()[0].message,
              "'limits.json' has no limits of precision; it is "
              "tests/torture/precision_limits.json");
}

TEST(Pages, have_the_torture_suite) {
    const auto torture = read_torture(R"({"size": [64, 48], "scenes": {"poles/two": {
        "reference": {"compared": 10, "undecided": 3, "fragile": 0},
        "tracers": {"auto": {"missed": 1, "phantom": 2, "moved": 0, "unresolved": 0},
                    "march": {"missed": 0, "phantom": 0, "moved": 0, "unresolved": 9}}}}})",
                                      "known.json");
    ASSERT_TRUE(torture);
    const std::string page = accuracy_page(hand_made(), *torture, {});
    EXPECT_TRUE(has(page, "| scene | undecided | auto | march |"));
    EXPECT_TRUE(has(page, "| poles/two | 3 | 3 (1, 2, 0) | 0 |"));
    EXPECT_EQ(read_torture("{}", "known.json").problems()[0].message,
              "'known.json' is no record of the torture suite; it is "
              "tests/torture/known_failures.json");
}

}  // namespace
}  // namespace bench
