// SPDX-License-Identifier: MIT
#include "cli/bench_command.h"

#include <chrono>
#include <cstdio>
#include <optional>

#include <fmt/format.h>

#include "bench/machine.h"
#include "bench/measure.h"
#include "bench/report_text.h"
#include "cli/input.h"
#include "cli/run.h"
#include "oracle/trace.h"
#include "render/context.h"

namespace cli {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// What is right; nothing if it is not wanted.
base::Result<std::optional<oracle::Reference>> reference_of(const BenchOptions& options,
                                                            const bench::Subject& subject) {
    if (options.no_reference) return std::optional<oracle::Reference>();
    oracle::Query query;
    query.width = options.run.reference_width;
    query.height = options.run.reference_height;
    auto reference = oracle::trace(subject.formula, subject.document, query);
    if (!reference) return reference.problems();
    return std::optional(std::move(*reference));
}

base::Result<bench::Measured> measure_one(render::Context& context, const BenchOptions& options,
                                          const bench::NamedFile& file) {
    const double aspect = static_cast<double>(options.run.width) / options.run.height;
    const auto subject = bench::read_subject(file.path, file.name, aspect);
    if (!subject) return subject.problems();
    const auto start = std::chrono::steady_clock::now();
    const auto reference = reference_of(options, *subject);
    if (!reference) return reference.problems();
    const double seconds = seconds_since(start);
    auto measured =
        bench::measure(context, *subject, options.run, *reference ? &**reference : nullptr);
    if (measured && *reference) measured->report.reference_seconds = seconds;
    return measured;
}

/// Measures one preset after the other and prints each at once.
base::Result<bench::Report> measure_all(const BenchOptions& options,
                                        const std::vector<bench::NamedFile>& files) {
    auto context = options.backend == "egl" ? render::open_egl() : render::open_osmesa();
    if (!context) return context.problems();
    bench::Report report;
    report.machine = bench::describe_machine(**context, options.backend);
    report.width = options.run.width;
    report.height = options.run.height;
    report.rounds = options.run.rounds;
    if (!options.no_reference) {
        report.reference_width = options.run.reference_width;
        report.reference_height = options.run.reference_height;
    }
    report.command = options.command;
    fmt::print("{}", bench::machine_text(report));
    for (const bench::NamedFile& file : files) {
        auto measured = measure_one(**context, options, file);
        if (!measured) return measured.problems();
        fmt::print("{}", bench::preset_text(measured->report));
        std::fflush(stdout);
        report.presets.push_back(std::move(measured->report));
    }
    return report;
}

}  // namespace

int bench_command(const BenchOptions& options) {
    const auto files = bench::find_subjects(options.presets);
    if (!files) {
        report(files.problems());
        return failed;
    }
    const auto measured = measure_all(options, *files);
    if (!measured) {
        report(measured.problems());
        return failed;
    }
    return success;
}

}  // namespace cli
