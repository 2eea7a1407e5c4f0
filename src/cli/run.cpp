// SPDX-License-Identifier: MIT
#include "cli/run.h"

#include <exception>
#include <map>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/bench_command.h"
#include "cli/check_command.h"
#include "cli/compare_command.h"
#include "cli/emit_command.h"
#include "cli/input.h"
#include "cli/oracle_command.h"
#include "cli/render_command.h"
#include "cli/render_options.h"
#include "scene/preset.h"
#include "studio/studio.h"

namespace cli {
namespace {

/// All that the command line can say.
struct Arguments {
    InputOptions input;
    CheckOptions check;
    CompareOptions compare;
    RenderOptions render;
    RenderOutputs outputs;
    BenchOptions bench;
    OracleOptions oracle;
    Emitted emitted = Emitted::glsl;
    std::string studio_preset;
};

CLI::App* add_render(CLI::App& app, Arguments& a) {
    CLI::App* command = app.add_subcommand("render", "Renders without a display");
    add_input_options(*command, a.input);
    add_render_options(*command, a.render);
    command->add_option("-o,--output", a.outputs.picture, "The shaded picture")
        ->type_name("FILE.png");
    command
        ->add_option("--depth", a.outputs.depth,
                     "Distance from the eye along the unit ray; +infinity for a miss")
        ->type_name("FILE.pfm");
    command->add_option("--normal", a.outputs.normal, "Unit normal, facing the eye; 0 for a miss")
        ->type_name("FILE.pfm");
    command
        ->add_option("--certificate", a.outputs.certificate,
                     "What is proven, a colour each: a hit light grey, a miss dark blue, a hit "
                     "within rounding yellow, a hit by guessed steps orange, a miss by such brown, "
                     "out of steps magenta")
        ->type_name("FILE.png");
    command->add_option("--stats", a.outputs.stats, "Statistics as JSON; - for standard output")
        ->type_name("FILE.json");
    command->add_option("--repeat", a.outputs.repeat, "Render so many frames more, each timed")
        ->check(CLI::Range(0, 100000))
        ->type_name("N");
    return command;
}

CLI::App* add_oracle(CLI::App& app, Arguments& a) {
    CLI::App* command =
        app.add_subcommand("oracle", "The first hit of every pixel's ray on the CPU, with proof");
    add_input_options(*command, a.input);
    add_render_options(*command, a.render);
    add_oracle_options(*command, a.oracle);
    return command;
}

CLI::App* add_check(CLI::App& app, Arguments& a) {
    CLI::App* command = app.add_subcommand("check", "Parses and checks; renders nothing");
    add_input_options(*command, a.input);
    command->add_flag(
        "--facts", a.check.facts,
        "Prints what is known: degree, smoothness, distance, extent, dependences, cost");
    command->add_flag("--json", a.check.json, "Prints the facts as JSON");
    return command;
}

CLI::App* add_emit(CLI::App& app, Arguments& a) {
    CLI::App* command = app.add_subcommand("emit", "Prints what the compiler made");
    add_input_options(*command, a.input);
    add_render_options(*command, a.render);
    const std::map<std::string, Emitted> names{
        {"glsl", Emitted::glsl}, {"graph", Emitted::graph}, {"ast", Emitted::ast}};
    command->add_option("--what", a.emitted, "The program, the expressions, or the syntax tree")
        ->required()
        ->transform(CLI::Transformer(names))
        ->type_name("glsl|graph|ast");
    return command;
}

CLI::App* add_studio(CLI::App& app, Arguments& a) {
    CLI::App* command = app.add_subcommand("studio", "Opens the window (the default)");
    command->add_option("PRESET", a.studio_preset, "A preset file, or the name of a preset");
    return command;
}

int studio_command(const Arguments& a) {
    studio::Options options;
    auto preset = scene::find_preset(a.studio_preset.empty() ? "default" : a.studio_preset);
    if (preset) {
        options.preset = *preset;
    } else if (!a.studio_preset.empty()) {
        report(preset.problems());
        return failed;
    }
    const base::Status status = studio::run(options);
    if (!status) report(status.problems());
    return status ? success : failed;
}

/// As it would be typed, but for quotes; the program under its name.
std::string command_line(int argc, char** argv) {
    std::string text = "zeroset";
    for (int i = 1; i < argc; ++i) text += std::string(" ") + argv[i];
    return text;
}

int dispatch(int argc, char** argv) {
    Arguments a;
    a.bench.command = command_line(argc, argv);
    CLI::App app("Zeroset: a studio for implicit surfaces and 3-D fractals", "zeroset");
    app.set_version_flag("--version", "zeroset " ZEROSET_VERSION);
    app.require_subcommand(0, 1);
    const CLI::App* render = add_render(app, a);
    const CLI::App* oracle = add_oracle(app, a);
    const CLI::App* check_app = add_check(app, a);
    const CLI::App* emit_app = add_emit(app, a);
    CLI::App* bench_app = app.add_subcommand("bench", "Measures run time against error");
    add_bench_options(*bench_app, a.bench);
    const CLI::App* compare_app = add_compare(app, a.compare);
    add_studio(app, a);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
            return app.exit(error);
        }
        fmt::print(stderr, "zeroset: error: {}\nRun with --help for more information.\n",
                   error.what());
        return usage;
    }
    if (*render) return render_command(a.input, a.render, a.outputs);
    if (*oracle) return oracle_command(a.input, a.render, a.oracle);
    if (*check_app) return check(a.input, a.check);
    if (*emit_app) return emit(a.input, a.render, a.emitted);
    if (*bench_app) return bench_command(a.bench);
    if (*compare_app) return compare_command(a.compare);
    return studio_command(a);
}

}  // namespace

int run(int argc, char** argv) {
    try {
        return dispatch(argc, argv);
    } catch (const std::exception& error) {
        fmt::print(stderr, "zeroset: error: {}\n", error.what());
        return failed;
    }
}

}  // namespace cli
