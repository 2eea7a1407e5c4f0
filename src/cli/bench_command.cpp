// SPDX-License-Identifier: MIT
#include "cli/bench_command.h"

#include <cstdio>
#include <filesystem>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "base/file.h"
#include "bench/baseline.h"
#include "bench/generated.h"
#include "bench/machine.h"
#include "bench/measure.h"
#include "bench/pages.h"
#include "bench/report_csv.h"
#include "bench/report_html.h"
#include "bench/report_json.h"
#include "bench/report_text.h"
#include "cli/input.h"
#include "cli/output_file.h"
#include "cli/run.h"
#include "oracle/cache.h"
#include "render/context.h"

namespace cli {
namespace {

constexpr std::size_t largest_report = std::size_t{256} << 20;

/// What is right; nothing if it is not wanted.
base::Result<std::optional<oracle::Reference>> reference_of(const BenchOptions& options,
                                                            const bench::Subject& subject) {
    if (options.no_reference || bench::generated_scene(subject.name)) {
        return std::optional<oracle::Reference>();
    }
    oracle::Query query;
    query.width = options.run.reference_width;
    query.height = options.run.reference_height;
    auto reference = oracle::trace(subject.formula, subject.document, query,
                                   oracle::Cache(oracle::cache_folder()));
    if (!reference) return reference.problems();
    return std::optional(std::move(*reference));
}

base::Result<bench::Measured> measure_one(render::Context& context, const BenchOptions& options,
                                          const bench::NamedFile& file) {
    const double aspect = static_cast<double>(options.run.width) / options.run.height;
    const auto subject = bench::read_subject(file.path, file.name, aspect);
    if (!subject) return subject.problems();
    const auto reference = reference_of(options, *subject);
    if (!reference) return reference.problems();
    bench::Options run = options.run;
    if (bench::generated_scene(file.name)) {
        run.tracers = {"auto"};
        run.sweeps.clear();
    }
    return bench::measure(context, *subject, run, *reference ? &**reference : nullptr);
}

/// A run, and the pictures of each preset.
struct Run {
    bench::Report report;
    std::vector<std::vector<bench::MarkedPicture>> pictures;
};

/// Measures one preset after the other and prints each at once.
base::Result<Run> measure_all(const BenchOptions& options,
                              const std::vector<bench::NamedFile>& files) {
    auto context = render::open_headless(options.backend);
    if (!context) return context.problems();
    Run run;
    bench::Report& report = run.report;
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
        run.pictures.push_back(std::move(measured->pictures));
    }
    fmt::print("\nGeometric means of times to those of the shaders by hand and of the limit:\n{}",
               bench::means_table(report));
    return run;
}

/// What a file of tests/torture/ says; nothing if it is not there.
template <class Record, class Read>
base::Result<std::vector<Record>> read_record(const std::filesystem::path& path, Read read) {
    if (!std::filesystem::exists(path)) return std::vector<Record>();
    const auto text = base::read_text(path, largest_report);
    if (!text) return text.problems();
    return read(*text, path.string());
}

base::Status write_docs(const std::string& folder, const bench::Report& report) {
    namespace fs = std::filesystem;
    const fs::path suite = fs::path(folder) / ".." / "tests" / "torture";
    auto torture =
        read_record<bench::TortureScene>(suite / "known_failures.json", bench::read_torture);
    if (!torture) return torture.problems();
    for (bench::TortureScene& scene : *torture) {
        const fs::path file = suite / "scenes" / (scene.name + ".json");
        if (!fs::exists(file)) continue;
        const auto subject = bench::read_subject(file, scene.name, 4.0 / 3);
        if (!subject) return subject.problems();
        scene.smooth = subject->smooth;
    }
    const auto limits = read_record<bench::PrecisionLimit>(suite / "precision_limits.json",
                                                           bench::read_precision_limits);
    if (!limits) return limits.problems();
    const auto written = base::write_atomically(fs::path(folder) / "performance.md",
                                                bench::performance_page(report, *torture));
    if (!written) return written;
    return base::write_atomically(fs::path(folder) / "accuracy.md",
                                  bench::accuracy_page(report, *torture, *limits));
}

base::Status write(const BenchOptions& options, const Run& run) {
    const auto write_text = [](const std::string& path, const std::string& text) -> base::Status {
        if (path.empty()) return base::Done{};
        return base::write_atomically(path, text);
    };
    if (auto done = write_text(options.csv, bench::report_csv(run.report)); !done) return done;
    if (auto done = write_text(options.json, bench::report_json(run.report)); !done) return done;
    if (auto done = write_text(options.html, bench::report_html(run.report, run.pictures)); !done) {
        return done;
    }
    return options.docs.empty() ? base::Done{} : write_docs(options.docs, run.report);
}

base::Result<bench::Report> read_baseline(const std::string& path) {
    const auto text = base::read_text(path, largest_report);
    if (!text) return text.problems();
    return bench::read_report(*text, path);
}

int fail(const base::Diagnostics& problems) {
    report(problems);
    return failed;
}

/// What can be refused before the long run.
base::Status check_files(const BenchOptions& options) {
    for (const std::string& path : {options.csv, options.json, options.html}) {
        if (path.empty()) continue;
        if (auto writable = check_writable(path); !writable) return writable;
    }
    return base::Done{};
}

}  // namespace

int bench_command(const BenchOptions& options) {
    const auto files = bench::find_subjects(options.presets);
    if (!files) return fail(files.problems());
    if (auto checked = check_files(options); !checked) return fail(checked.problems());
    std::optional<bench::Report> baseline;
    if (!options.baseline.empty()) {
        auto read = read_baseline(options.baseline);
        if (!read) return fail(read.problems());
        baseline = std::move(*read);
    }
    const auto run = measure_all(options, *files);
    if (!run) return fail(run.problems());
    if (auto written = write(options, *run); !written) return fail(written.problems());
    if (!baseline) return success;
    const auto changes = bench::changes(*baseline, run->report);
    if (!changes) return fail(changes.problems());
    fmt::print("\nSince {}:\n{}", options.baseline, bench::changes_text(*changes));
    return options.fail_on_regression && bench::has_regression(*changes) ? failed : success;
}

}  // namespace cli
