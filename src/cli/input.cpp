// SPDX-License-Identifier: MIT
#include "cli/input.h"

#include <chrono>
#include <cstdio>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "base/file.h"
#include "scene/preset.h"

namespace cli {
namespace {

void print_all(const base::Diagnostics& problems, std::string_view name, std::string_view text) {
    for (const base::Diagnostic& problem : problems) {
        fmt::print(stderr, "{}", base::format(problem, name, text));
    }
}

/// The same problems of a formula with places in the source's text.
base::Diagnostics in_text(const Source& source, base::Diagnostics problems) {
    if (source.places.empty()) return problems;
    for (base::Diagnostic& problem : problems) {
        if (!problem.span) continue;
        const std::uint32_t last = static_cast<std::uint32_t>(source.places.size() - 1);
        const std::uint32_t begin = std::min(problem.span->begin, last);
        const std::uint32_t end = std::min(std::max(problem.span->end, begin), last);
        // The end is behind the last byte, not at the next one: that may be on another line.
        problem.span = {source.places[begin],
                        end > begin ? source.places[end - 1] + 1 : source.places[begin]};
    }
    return problems;
}

/// Fills source and document from the options; false after reporting errors.
bool read_document(const InputOptions& options, Source& source, scene::Document& document) {
    if (options.formula) {
        source = {"formula", *options.formula, {}, {}};
        document.formula = *options.formula;
        return true;
    }
    const auto path = scene::find_preset(options.preset);
    if (!path) {
        report(path.problems());
        return false;
    }
    const auto text = base::read_text(*path, scene::largest_preset);
    if (!text) {
        report(text.problems());
        return false;
    }
    auto preset = scene::read_preset(*text);
    if (!preset) {
        print_all(preset.problems(), path->string(), *text);
        return false;
    }
    print_all(preset->warnings, path->string(), *text);
    source = {path->string(), *text, std::move(preset->formula_places),
              std::move(preset->parameter_places)};
    document = std::move(preset->document);
    return true;
}

}  // namespace

void add_input_options(CLI::App& command, InputOptions& options) {
    auto* preset = command.add_option("PRESET", options.preset,
                                      "A preset file, or the name of a shipped or own preset");
    auto* formula =
        command.add_option("--formula", options.formula, "The formula itself instead of a preset");
    preset->excludes(formula);
    command.callback([&command, &options] {
        if (options.preset.empty() && !options.formula) {
            throw CLI::RequiredError(command.get_name() + ": PRESET or --formula");
        }
    });
}

std::optional<Input> read_input(const InputOptions& options) {
    Input input;
    if (!read_document(options, input.source, input.document)) return std::nullopt;
    const auto start = std::chrono::steady_clock::now();
    auto formula = compile::compile_formula(input.document.formula);
    input.parse_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!formula) {
        report(input.source, formula.problems());
        return std::nullopt;
    }
    report(input.source, formula->warnings);
    const auto problems = compile::check_parameters(formula->field, input.document.parameters,
                                                    input.source.parameters);
    print_all(problems, input.source.name, input.source.text);
    if (base::has_errors(problems)) return std::nullopt;
    input.formula = std::move(*formula);
    return input;
}

void report(const Source& source, const base::Diagnostics& problems) {
    print_all(in_text(source, problems), source.name, source.text);
}

void report(const base::Diagnostics& problems) { print_all(problems, "zeroset", ""); }

}  // namespace cli
