// SPDX-License-Identifier: MIT
#include "cli/bench_options.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/size.h"
#include "shader/program_source.h"

namespace cli {
namespace {

std::vector<std::string> tracer_names() {
    std::vector<std::string> names;
    for (const shader::TracerName& tracer : shader::tracers()) names.emplace_back(tracer.name);
    return names;
}

void add_sweep(bench::Options& run, const std::string& text) {
    auto sweep = bench::read_sweep(text);
    if (!sweep) throw CLI::ValidationError("--sweep", sweep.problems()[0].message);
    run.sweeps.push_back(std::move(*sweep));
}

void add_size(CLI::App& command, const std::string& name, const std::string& help, int& width,
              int& height) {
    command
        .add_option_function<std::string>(
            name,
            [name, &width, &height](const std::string& text) {
                const Size size = parse_size(text, name);
                width = size.width;
                height = size.height;
            },
            help)
        ->type_name("WxH");
}

void add_run_options(CLI::App& command, bench::Options& run) {
    run.tracers = tracer_names();
    run.passes = {"auto"};
    run.sweeps = {{"lipschitz", {0.5, 2}}, {"epsilon", {0.01, 0.5}}};
    command.add_option("--tracers", run.tracers, "Which tracers, with commas between (all)")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::IsMember(tracer_names()))
        ->type_name("NAMES");
    command
        .add_option("--passes", run.passes, "Tracers whose frame is told apart by passes (auto)")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::IsMember(tracer_names()))
        ->type_name("NAMES");
    command
        .add_option_function<std::vector<std::string>>(
            "--sweep",
            [&run](const std::vector<std::string>& list) {
                run.sweeps.clear();
                for (const std::string& text : list) {
                    if (text != "none") add_sweep(run, text);
                }
            },
            "Values of a setting that are tried besides the preset's own, such as steps=64,256; of "
            "lipschitz, steps and epsilon; repeatable; none for none (lipschitz=0.5,2 and "
            "epsilon=0.01,0.5)")
        ->type_name("NAME=VALUES")
        ->expected(1)
        ->take_all();
    add_size(command, "--size", "Pixels of what is timed (640x480)", run.width, run.height);
    add_size(command, "--reference-size", "Pixels of what is held against the reference (320x240)",
             run.reference_width, run.reference_height);
    command.add_option("--rounds", run.rounds, "How often everything is drawn (7)")
        ->check(CLI::Range(1, 1000))
        ->type_name("N");
    command.add_option("--seed", run.seed, "Of the orders in which things are drawn (1)")
        ->type_name("N");
}

void add_output_options(CLI::App& command, BenchOptions& options) {
    command.add_option("--csv", options.csv, "Everything as a table for other programs")
        ->type_name("FILE.csv");
    command.add_option("--json", options.json, "Everything, to be a baseline later")
        ->type_name("FILE.json");
    command.add_option("--html", options.html, "A page with plots, tables and marked pictures")
        ->type_name("FILE.html");
    auto* baseline =
        command.add_option("--baseline", options.baseline, "Shows what changed since that run")
            ->type_name("OLD.json");
    command
        .add_flag("--fail-on-regression", options.fail_on_regression,
                  "Exit status 1 if something is slower or more wrong than the baseline")
        ->needs(baseline);
    command
        .add_option("--docs", options.docs,
                    "Writes performance.md and accuracy.md there; that has the record of the "
                    "torture suite from ../tests/torture/known_failures.json, if it is there")
        ->check(CLI::ExistingDirectory)
        ->type_name("FOLDER");
}

}  // namespace

void add_bench_options(CLI::App& command, BenchOptions& options) {
    command.add_option("PRESETS", options.presets,
                       "Presets, or folders of them, by path or shipped name (all shipped ones)");
    add_run_options(command, options.run);
    add_output_options(command, options);
    command.add_flag("--no-reference", options.no_reference,
                     "Without reference pictures, which take longest: errors are left open");
    command.add_option("--backend", options.backend, "The headless OpenGL in use (osmesa)")
        ->check(CLI::IsMember({"osmesa", "egl"}))
        ->type_name("osmesa|egl");
}

}  // namespace cli
