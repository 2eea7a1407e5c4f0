// SPDX-License-Identifier: MIT
#include "cli/render_command.h"

#include <chrono>
#include <cstdio>
#include <utility>

#include <fmt/format.h>

#include "base/file.h"
#include "cli/output_file.h"
#include "cli/run.h"
#include "cli/stats.h"
#include "compile/check_scene.h"
#include "compile/precision.h"
#include "compile/step_rules.h"
#include "image/pfm.h"
#include "image/png.h"
#include "render/context.h"
#include "render/still.h"

namespace cli {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// One channel of the geometry, or three of the normals.
template <class Result>
Result channels(const image::Image<float, 4>& source) {
    Result result(source.width, source.height);
    const std::size_t pixels = source.values.size() / 4;
    for (std::size_t i = 0; i < pixels; ++i) {
        for (int c = 0; c < Result::channels; ++c) {
            result.values[i * Result::channels + c] = source.values[i * 4 + c];
        }
    }
    return result;
}

bool done(const base::Status& status) {
    if (!status) report(status.problems());
    return static_cast<bool>(status);
}

/// A render on its way: the input, a context, and what to write.
struct Run {
    Input& input;
    const RenderOptions& options;
    render::Context& context;
    double analyse_seconds = 0;
    shader::FieldNumbers numbers{};  ///< of the last draw
    std::vector<compile::StepRule> rules{};

    base::Result<render::Still> draw(const shader::Outputs& outputs, int repeat) {
        const auto start = std::chrono::steady_clock::now();
        const shader::ProgramSource source =
            compile::program_source(input.formula, input.document, outputs);
        numbers = compile::field_numbers(input.formula, source, input.document);
        analyse_seconds = seconds_since(start);
        rules = compile::step_rules(input.formula.field, source, numbers, input.document);
        const scene::Document& document = input.document;
        const auto frame_of = [&document](const render::View& view) {
            return render::frame(document, *document.camera, view);
        };
        return render::draw_still(context, source, numbers, frame_of, options.view(), outputs,
                                  repeat);
    }

    /// Evaluations and certificate of the primary rays, by a program that counts.
    base::Result<render::Still> counted() {
        const double analysed = analyse_seconds;
        auto still =
            draw({.picture = false, .normal = true, .count = true, .certificate = true}, 0);
        analyse_seconds = analysed;
        return still;
    }

    /// What is proven, as colours.
    base::Status write_certificate(const std::string& path) {
        scene::Settings& settings = input.document.settings;
        const bool shown = std::exchange(settings.show_certificate, true);
        const auto still = draw({.picture = true}, 0);
        settings.show_certificate = shown;
        if (!still) return still.problems();
        return image::write_png(path, still->picture);
    }
};

base::Result<std::string> stats_of(Run& run, const render::Still& still) {
    const std::vector<compile::StepRule> rules = run.rules;
    const auto counted = run.counted();
    if (!counted) return counted.problems();
    const compile::PrecisionChoice choice =
        compile::choose_precision(run.input.formula, run.input.document);
    return stats_json(still, *counted,
                      {.tracer = run.input.document.settings.tracer,
                       .backend = run.options.backend,
                       .renderer = run.context.renderer(),
                       .precision = std::string(shader::name_of(choice.precision)),
                       .precision_reason = choice.reason,
                       .parse_seconds = run.input.parse_seconds,
                       .analyse_seconds = run.analyse_seconds,
                       .rules = rules,
                       .bricks = run.numbers.bricks,
                       .brick_seconds = run.numbers.brick_seconds});
}

bool write(const RenderOutputs& outputs, const render::Still& still, const std::string& stats) {
    bool good = true;
    if (!outputs.picture.empty()) good &= done(image::write_png(outputs.picture, still.picture));
    if (!outputs.depth.empty()) {
        good &= done(image::write_pfm(outputs.depth, channels<image::Grey>(still.geometry)));
    }
    if (!outputs.normal.empty()) {
        good &= done(image::write_pfm(outputs.normal, channels<image::Vectors>(still.normal)));
    }
    if (outputs.stats == "-") {
        fmt::print("{}", stats);
    } else if (!outputs.stats.empty()) {
        good &= done(base::write_atomically(outputs.stats, stats));
    }
    return good;
}

}  // namespace

int render_command(const InputOptions& input_options, const RenderOptions& options,
                   const RenderOutputs& outputs) {
    auto input = read_input(input_options);
    if (!input) return failed;
    if (!apply(options, *input)) return usage;
    report(input->source, compile::check_scene(input->formula, input->document));
    for (const std::string& path :
         {outputs.picture, outputs.depth, outputs.normal, outputs.certificate, outputs.stats}) {
        if (!path.empty() && path != "-" && !done(check_writable(path))) return failed;
    }
    auto context = render::open_headless(options.backend);
    if (!context) {
        report(context.problems());
        return failed;
    }
    Run run{*input, options, **context};
    const shader::Outputs written{.picture = true,  // also if only timed: a frame is a whole frame
                                  .geometry = !outputs.depth.empty() || !outputs.stats.empty(),
                                  .normal = !outputs.normal.empty()};
    const auto still = run.draw(written, outputs.repeat);
    if (!still) {
        report(still.problems());
        return failed;
    }
    std::string stats;
    if (!outputs.stats.empty()) {
        auto text = stats_of(run, *still);
        if (!text) {
            report(text.problems());
            return failed;
        }
        stats = std::move(*text);
    }
    bool good = write(outputs, *still, stats);
    if (!outputs.certificate.empty()) good &= done(run.write_certificate(outputs.certificate));
    return good ? success : failed;
}

}  // namespace cli
