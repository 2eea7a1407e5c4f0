// SPDX-License-Identifier: MIT
#include "cli/oracle_command.h"

#include <chrono>
#include <cstdio>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "base/file.h"
#include "cli/oracle_stats.h"
#include "cli/output_file.h"
#include "cli/run.h"
#include "compile/check_scene.h"
#include "image/pfm.h"
#include "image/png.h"
#include "oracle/cache.h"
#include "oracle/picture.h"
#include "oracle/reference_file.h"
#include "oracle/trace.h"

namespace cli {
namespace {

bool done(const base::Status& status) {
    if (!status) report(status.problems());
    return static_cast<bool>(status);
}

bool write(const OracleOptions& options, const Input& input, const oracle::Query& query,
           const oracle::Reference& reference, const std::string& stats) {
    bool good = true;
    if (!options.picture.empty()) {
        good &=
            done(image::write_png(options.picture, oracle::shaded_picture(reference, input.formula,
                                                                          input.document, query)));
    }
    if (!options.certificate.empty()) {
        good &= done(image::write_png(options.certificate, oracle::certificate_picture(reference)));
    }
    if (!options.depth.empty()) {
        good &= done(image::write_pfm(options.depth, oracle::depths(reference)));
    }
    if (!options.normal.empty()) {
        good &= done(image::write_pfm(options.normal, oracle::normals(reference)));
    }
    if (!options.reference.empty()) {
        good &= done(oracle::write_reference(options.reference, reference));
    }
    if (options.stats == "-") {
        fmt::print("{}", stats);
    } else if (!options.stats.empty()) {
        good &= done(base::write_atomically(options.stats, stats));
    }
    return good;
}

}  // namespace

void add_oracle_options(CLI::App& command, OracleOptions& options) {
    const auto add = [&](const char* name, std::string& target, const char* help,
                         const char* type) {
        command.add_option(name, target, help)->type_name(type);
    };
    add("-o,--output", options.picture, "The shaded picture, without shadows", "FILE.png");
    add("--depth", options.depth,
        "Distance from the eye along the unit ray; +infinity for a miss; the best estimate where "
        "undecided",
        "FILE.pfm");
    add("--normal", options.normal, "Unit normal, facing the eye; 0 for a miss", "FILE.pfm");
    add("--certificate", options.certificate,
        "What is proven, a colour each: a hit light grey, a miss dark blue, undecided magenta, "
        "too close to an outline yellow; where nothing is proven, since the scene has escape-time "
        "sets other than those of q^2 + c: a hit orange, a miss brown",
        "FILE.png");
    add("--reference", options.reference, "All of it, for 'zeroset compare'", "FILE");
    add("--stats", options.stats, "Statistics as JSON; - for standard output", "FILE.json");
    command.add_option("--threads", options.threads, "So many threads (as many as cores)")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    command.add_flag("--no-cache", options.no_cache,
                     "Neither looks for the result of an earlier run nor keeps this one");
}

int oracle_command(const InputOptions& input_options, const RenderOptions& render,
                   const OracleOptions& options) {
    auto input = read_input(input_options);
    if (!input) return failed;
    if (!apply(render, *input)) return usage;
    report(input->source, compile::check_scene(input->formula, input->document));
    for (const std::string& path : {options.picture, options.depth, options.normal, options.stats,
                                    options.certificate, options.reference}) {
        if (!path.empty() && path != "-" && !done(check_writable(path))) return failed;
    }
    const oracle::Query query{.width = render.width,
                              .height = render.height,
                              .region = render.region,
                              .threads = options.threads,
                              .progress = {}};
    const auto start = std::chrono::steady_clock::now();
    const oracle::Cache cache(options.no_cache ? "" : oracle::cache_folder());
    const auto reference = oracle::trace(input->formula, input->document, query, cache);
    if (!reference) {
        report(reference.problems());
        return failed;
    }
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const std::string stats = oracle_stats_json(*reference, seconds);
    return write(options, *input, query, *reference, stats) ? success : failed;
}

}  // namespace cli
