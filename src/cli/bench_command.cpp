// SPDX-License-Identifier: MIT
#include "cli/bench_command.h"

#include <cstdio>

#include <fmt/format.h>

#include "bench/machine.h"
#include "bench/measure.h"
#include "bench/report_text.h"
#include "cli/input.h"
#include "cli/run.h"
#include "render/context.h"

namespace cli {
namespace {

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
    report.command = options.command;
    fmt::print("{}", bench::machine_text(report));
    const double aspect = static_cast<double>(options.run.width) / options.run.height;
    for (const bench::NamedFile& file : files) {
        const auto subject = bench::read_subject(file.path, file.name, aspect);
        if (!subject) return subject.problems();
        auto measured = bench::measure(**context, *subject, options.run, nullptr);
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
