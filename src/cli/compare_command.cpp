// SPDX-License-Identifier: MIT
#include "cli/compare_command.h"

#include <cstdio>
#include <fstream>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "base/file.h"
#include "cli/comparison.h"
#include "cli/input.h"
#include "cli/output_file.h"
#include "cli/run.h"
#include "image/pfm.h"
#include "image/png.h"
#include "oracle/marked_picture.h"
#include "oracle/reference_file.h"
#include "oracle/reference_of_depth.h"
#include "scene/camera.h"

namespace cli {
namespace {

bool begins_as_pfm(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return file.get() == 'P';
}

base::Result<oracle::Reference> read_depth_reference(const CompareOptions& options) {
    const auto depth = image::read_pfm_grey(options.reference);
    if (!depth) return depth.problems();
    if (options.normals.empty()) return oracle::reference_of_depth(*depth, {}, options.fov);
    if (options.normals.size() == 1) {
        return base::error(fmt::format(
            "'{}' holds depths alone; --normals must name the normals of both, its own first",
            options.reference));
    }
    const auto normal = image::read_pfm_vectors(options.normals[0]);
    if (!normal) return normal.problems();
    return oracle::reference_of_depth(*depth, *normal, options.fov);
}

base::Result<oracle::Reference> read_reference(const CompareOptions& options) {
    if (begins_as_pfm(options.reference)) return read_depth_reference(options);
    auto reference = oracle::read_reference(options.reference);
    if (reference && options.normals.size() == 2) {
        return base::error(fmt::format(
            "'{}' holds normals as well; --normals must name those of the other picture alone",
            options.reference));
    }
    return reference;
}

base::Result<oracle::Shot> read_shot(const CompareOptions& options) {
    oracle::Shot shot;
    auto depth = image::read_pfm_grey(options.depth);
    if (!depth) return depth.problems();
    shot.depth = std::move(*depth);
    if (!options.normals.empty()) {
        auto normal = image::read_pfm_vectors(options.normals.back());
        if (!normal) return normal.problems();
        shot.normal = std::move(*normal);
    }
    return shot;
}

base::Result<image::Difference> compare_pictures(const std::vector<std::string>& paths) {
    const auto expected = image::read_png(paths[0]);
    if (!expected) return expected.problems();
    const auto actual = image::read_png(paths[1]);
    if (!actual) return actual.problems();
    if (expected->width != actual->width || expected->height != actual->height) {
        return base::error(fmt::format(
            "'{}' has {}x{} pixels, '{}' {}x{}; compare pictures of one size", paths[0],
            expected->width, expected->height, paths[1], actual->width, actual->height));
    }
    return image::compare(*expected, *actual, oracle::visible_colour_difference);
}

base::Status write(const CompareOptions& options, const oracle::Reference& reference,
                   const Comparison& comparison) {
    if (options.json == "-") {
        fmt::print("{}", comparison_json(comparison));
    } else {
        fmt::print("{}", comparison_text(comparison));
        if (!options.json.empty()) {
            const auto status = base::write_atomically(options.json, comparison_json(comparison));
            if (!status) return status;
        }
    }
    if (options.marked.empty()) return base::Done{};
    return image::write_png(options.marked, oracle::marked_picture(reference, comparison.metrics));
}

base::Result<Comparison> compare_files(const CompareOptions& options,
                                       const oracle::Reference& reference) {
    const auto shot = read_shot(options);
    if (!shot) return shot.problems();
    auto metrics = oracle::compare(reference, *shot);
    if (!metrics) return metrics.problems();
    Comparison comparison{std::move(*metrics), reference.heuristic, !options.normals.empty(), {}};
    if (!options.pictures.empty()) {
        auto difference = compare_pictures(options.pictures);
        if (!difference) return difference.problems();
        comparison.picture = std::move(*difference);
    }
    return comparison;
}

template <class Result>
int fail(const Result& result) {
    report(result.problems());
    return failed;
}

}  // namespace

CLI::App* add_compare(CLI::App& app, CompareOptions& o) {
    CLI::App* command = app.add_subcommand("compare", "Says how wrong a picture is");
    command
        ->add_option("REF", o.reference,
                     "What is right: the file of `oracle --reference`, or a PFM of depths, which "
                     "leaves nothing undecided and nothing fragile")
        ->required()
        ->type_name("FILE");
    command->add_option("GOT", o.depth, "What is judged: depths, as `render --depth` writes them")
        ->required()
        ->type_name("FILE.pfm");
    command
        ->add_option("--normals", o.normals,
                     "Normals of GOT, as `render --normal` writes them; before them those of REF "
                     "if that is a PFM")
        ->expected(1, 2)
        ->type_name("FILE.pfm");
    command->add_option("--pictures", o.pictures, "Shaded pictures of both")
        ->expected(2)
        ->type_name("FILE.png");
    command->add_option("--fov", o.fov, "Vertical field of view in degrees where REF is a PFM (45)")
        ->check(CLI::Range(scene::least_fov, scene::greatest_fov))
        ->type_name("NUMBER");
    command->add_option("--json", o.json, "The numbers as JSON; - for standard output")
        ->type_name("FILE.json");
    command
        ->add_option("--marked", o.marked,
                     "The depths in grey, with missed pixels red, phantoms blue, moved ones yellow "
                     "and those that are not compared violet")
        ->type_name("FILE.png");
    command->add_option("--fail-above", o.fail_above, "Exit status 1 if more pixels are wrong")
        ->check(CLI::NonNegativeNumber)
        ->type_name("N");
    return command;
}

int compare_command(const CompareOptions& options) {
    for (const std::string& path : {options.json, options.marked}) {
        if (path.empty() || path == "-") continue;
        if (const auto status = check_writable(path); !status) return fail(status);
    }
    const auto reference = read_reference(options);
    if (!reference) return fail(reference);
    const auto comparison = compare_files(options, *reference);
    if (!comparison) return fail(comparison);
    if (const auto status = write(options, *reference, *comparison); !status) return fail(status);
    const auto wrong = static_cast<long long>(comparison->metrics.wrong());
    return options.fail_above && wrong > *options.fail_above ? failed : success;
}

}  // namespace cli
