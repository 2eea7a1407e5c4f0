// SPDX-License-Identifier: MIT
#include "cli/render_options.h"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/number.h"
#include "cli/set_parameter.h"
#include "cli/size.h"
#include "shader/program_source.h"

namespace cli {
namespace {

double number(std::string_view text, std::string_view option) {
    const auto value = finite_number(text);
    if (value) return *value;
    throw CLI::ValidationError(std::string(option),
                               fmt::format("'{}' is not a finite number", text));
}

std::vector<double> numbers(std::string_view text, std::string_view option) {
    std::vector<double> list;
    for (std::size_t begin = 0;;) {
        const std::size_t comma = std::min(text.find(',', begin), text.size());
        list.push_back(number(text.substr(begin, comma - begin), option));
        if (comma == text.size()) return list;
        begin = comma + 1;
    }
}

glm::dvec3 vector(std::string_view text, std::string_view option) {
    const std::vector<double> list = numbers(text, option);
    if (list.size() != 3) {
        throw CLI::ValidationError(std::string(option), fmt::format("'{}' should be X,Y,Z", text));
    }
    return {list[0], list[1], list[2]};
}

void parse_region(std::string_view text, RenderOptions& options) {
    std::array<int, 4> region{};
    std::size_t begin = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t comma = std::min(text.find(',', begin), text.size());
        if ((comma == text.size()) != (i == 3)) {
            throw CLI::ValidationError("--region", fmt::format("'{}' should be X,Y,W,H", text));
        }
        region[i] = whole_number(text.substr(begin, comma - begin), "--region");
        begin = comma + 1;
    }
    options.region = region;
}

scene::Bounds parse_bounds(std::string_view text) {
    using Shape = scene::Bounds::Shape;
    if (text == "none") return {Shape::none, glm::dvec3(0), glm::dvec3(2)};
    const auto refuse = [&] {
        return CLI::ValidationError(
            "--bounds", fmt::format("'{}' should be sphere:R, sphere:X,Y,Z,R, box:HX,HY,HZ, "
                                    "box:X,Y,Z,HX,HY,HZ or none, with sizes above 0",
                                    text));
    };
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) throw refuse();
    const std::string_view shape = text.substr(0, colon);
    const std::vector<double> v = numbers(text.substr(colon + 1), "--bounds");
    scene::Bounds bounds;
    if (shape == "sphere" && (v.size() == 1 || v.size() == 4)) {
        bounds.half = glm::dvec3(v.back());
    } else if (shape == "box" && (v.size() == 3 || v.size() == 6)) {
        bounds.shape = Shape::box;
        bounds.half = {v[v.size() - 3], v[v.size() - 2], v[v.size() - 1]};
    } else {
        throw refuse();
    }
    if (v.size() >= 4) bounds.centre = {v[0], v[1], v[2]};
    if (std::min({bounds.half.x, bounds.half.y, bounds.half.z}) <= 0) throw refuse();
    return bounds;
}

void parse_set(std::string_view text, RenderOptions& options) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos || equals == 0) {
        throw CLI::ValidationError("--set", fmt::format("'{}' should be NAME=VALUE", text));
    }
    options.parameters.emplace_back(text.substr(0, equals), text.substr(equals + 1));
}

/// An option whose text goes through a function of ours.
template <class Take>
void add(CLI::App& command, const std::string& name, const std::string& shape,
         const std::string& help, Take take) {
    command
        .add_option_function<std::string>(
            name, [take](const std::string& text) { take(text); }, help)
        ->type_name(shape);
}

template <class Target>
void add_number(CLI::App& command, const std::string& name, const std::string& help, double least,
                double most, Target& target) {
    add(command, name, "NUMBER", help, [=, &target](const std::string& text) {
        const double value = number(text, name);
        if (value < least || value > most) {
            throw CLI::ValidationError(
                name, fmt::format("{} is out of range; it goes from {} to {}", text, least, most));
        }
        target = static_cast<typename Target::value_type>(value);
    });
}

void add_camera_options(CLI::App& command, RenderOptions& o) {
    add(command, "--size", "WxH", "Pixels (1280x720)", [&o](const std::string& text) {
        const Size size = parse_size(text, "--size");
        o.width = size.width;
        o.height = size.height;
    });
    add(command, "--region", "X,Y,W,H", "Only this part of the picture, from the left and the top",
        [&o](const std::string& text) { parse_region(text, o); });
    add(command, "--eye", "X,Y,Z", "Where the camera is",
        [&o](const std::string& text) { o.eye = vector(text, "--eye"); });
    add(command, "--target", "X,Y,Z", "What it looks at",
        [&o](const std::string& text) { o.target = vector(text, "--target"); });
    add(command, "--up", "X,Y,Z", "What is up in the picture (+y)",
        [&o](const std::string& text) { o.up = vector(text, "--up"); });
    add_number(command, "--fov", "Vertical field of view in degrees (45)", 0.001, 179, o.fov);
    add(command, "--bounds", "REGION",
        "The region that is looked at: sphere:R, sphere:X,Y,Z,R, box:HX,HY,HZ, box:X,Y,Z,HX,HY,HZ "
        "or none (the preset's, else sphere:2)",
        [&o](const std::string& text) { o.bounds = parse_bounds(text); });
}

void add_tracing_options(CLI::App& command, RenderOptions& o) {
    std::string tracers = "How rays go:";
    std::vector<std::string> names;
    for (const shader::TracerName& tracer : shader::tracers()) {
        tracers += fmt::format("\n  {}: {}", tracer.name, tracer.summary);
        names.emplace_back(tracer.name);
    }
    command.add_option("--tracer", o.tracer, tracers)
        ->check(CLI::IsMember(names))
        ->type_name("NAME");
    command
        .add_option(
            "--precision", o.precision,
            "In which numbers the picture is calculated (auto: single, about the target, or "
            "double, whichever is enough)")
        ->check(CLI::IsMember({"auto", "single", "double"}))
        ->type_name("auto|single|double");
    add(command, "--steps", "N", "Most steps of a ray", [&o](const std::string& text) {
        const int value = whole_number(text, "--steps");
        if (value < 1 || value > 100000) {
            throw CLI::ValidationError("--steps",
                                       text + " is out of range; it goes from 1 to 100000");
        }
        o.steps = value;
    });
    add_number(command, "--lipschitz", "Every step is divided by this (1)", 1e-3, 1e6, o.lipschitz);
    add_number(command, "--epsilon", "A hit is closer than this part of a pixel (0.1)", 1e-6, 100,
               o.epsilon);
    add_number(command, "--shadow", "Shadow factor: small is soft, large is hard (12)", 1e-3, 1e6,
               o.shadow);
    command.add_flag("--no-shadow", o.no_shadow, "No shadows");
    command.add_flag("--no-ao", o.no_ambient_occlusion, "No ambient occlusion (none is drawn yet)");
    command.add_flag("--show-steps", o.show_steps, "Colour the number of steps instead of shading");
}

}  // namespace

render::View RenderOptions::view() const {
    render::View view = render::whole(width, height);
    if (region) {
        view.x = (*region)[0];
        view.y = (*region)[1];
        view.region_width = (*region)[2];
        view.region_height = (*region)[3];
    }
    return view;
}

void add_render_options(CLI::App& command, RenderOptions& options) {
    add_camera_options(command, options);
    command
        .add_option_function<std::vector<std::string>>(
            "--set",
            [&options](const std::vector<std::string>& list) {
                for (const std::string& text : list) parse_set(text, options);
            },
            "A parameter of the formula, or t; repeatable. A vector is c=0.1,0.2,0 or c.x=0.1, a "
            "choice shape=round, a toggle cut=on")
        ->type_name("NAME=VALUE")
        ->expected(1)
        ->take_all();
    add_tracing_options(command, options);
    command.add_option("--backend", options.backend, "The headless OpenGL in use (osmesa)")
        ->check(CLI::IsMember({"osmesa", "egl"}))
        ->type_name("osmesa|egl");
}

bool apply(const RenderOptions& options, Input& input) {
    const render::View view = options.view();
    // Sums as 64 bits: a region may start or reach anywhere.
    if (view.x < 0 || view.y < 0 || view.region_width < 1 || view.region_height < 1 ||
        static_cast<long long>(view.x) + view.region_width > view.width ||
        static_cast<long long>(view.y) + view.region_height > view.height) {
        fmt::print(stderr,
                   "zeroset: error: --region: {},{},{},{} is not inside of the picture of {}x{} "
                   "pixels; it is X,Y,W,H from the left and the top\n",
                   view.x, view.y, view.region_width, view.region_height, view.width, view.height);
        return false;
    }
    scene::Document& d = input.document;
    for (const auto& [name, value] : options.parameters) {
        const auto status = set_parameter(input.formula.field, name, value, d);
        if (status) continue;
        fmt::print(stderr, "zeroset: error: --set: {}\n", status.problems()[0].message);
        return false;
    }
    if (options.bounds) d.bounds = *options.bounds;
    if (options.tracer) d.settings.tracer = *options.tracer;
    if (options.precision) d.settings.precision = *options.precision;
    if (options.steps) d.settings.steps = *options.steps;
    if (options.lipschitz) d.settings.lipschitz = *options.lipschitz;
    if (options.epsilon) d.settings.epsilon = *options.epsilon;
    if (options.shadow) d.settings.shadow = *options.shadow;
    if (options.no_shadow) d.settings.shadows = false;
    if (options.no_ambient_occlusion) d.settings.ambient_occlusion = false;
    if (options.show_steps) d.settings.show_steps = true;
    d.settings.grid = false;
    const double aspect = static_cast<double>(options.width) / options.height;
    scene::Camera camera =
        d.camera ? *d.camera : scene::frame_all(d.bounds, aspect, options.fov.value_or(45));
    if (options.eye) camera.eye = *options.eye;
    if (options.target) camera.target = *options.target;
    if (options.up) camera.up = *options.up;
    if (options.fov) camera.fov = *options.fov;
    if (camera.eye == camera.target) {
        fmt::print(stderr, "zeroset: error: eye and target are the same point; move one of them\n");
        return false;
    }
    d.camera = camera;
    return true;
}

}  // namespace cli
