// SPDX-License-Identifier: MIT
#include "torture/tracing.h"
#include "headless.h"

#include <gtest/gtest.h>

#include "oracle/trace.h"
#include "render/frame.h"
#include "render/still.h"

namespace torture {
namespace {

oracle::Shot shot_of(const render::Still& still) {
    oracle::Shot shot;
    const int width = still.geometry.width;
    const int height = still.geometry.height;
    shot.depth = image::Grey(width, height);
    shot.normal = image::Vectors(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const float* geometry = still.geometry.at(x, y);
            *shot.depth.at(x, y) = geometry[0];
            shot.gave_up.push_back(static_cast<shader::Status>(geometry[2]) ==
                                   shader::Status::unresolved);
            std::copy_n(still.normal.at(x, y), 3, shot.normal.at(x, y));
        }
    }
    return shot;
}

/// One for the whole run: opening it costs more than drawing most scenes.
render::Context* context() {
    static const auto context = open_headless();
    if (!context) ADD_FAILURE() << text_of(context.problems());
    return context ? context->get() : nullptr;
}

}  // namespace

std::vector<Variant> variants() {
    std::vector<Variant> list;
    for (const shader::TracerName& tracer : shader::tracers()) {
        const std::string name(tracer.name);
        list.push_back({name, name, std::nullopt});
    }
    list.push_back({"auto, epsilon 0.01", "auto", 0.01});
    return list;
}

oracle::Shot render(const Scene& scene, const Variant& variant, int width, int height) {
    if (!context()) return {};
    scene::Document document = scene.document;
    document.settings.tracer = variant.tracer;
    if (variant.epsilon) document.settings.epsilon = *variant.epsilon;
    const shader::Outputs outputs{.picture = false, .geometry = true, .normal = true};
    const shader::ProgramSource source = compile::program_source(scene.formula, document, outputs);
    const shader::FieldNumbers numbers = compile::field_numbers(scene.formula, source, document);
    const scene::Camera camera = scene::camera_of(document, static_cast<double>(width) / height);
    const auto frame_of = [&](const render::View& view) {
        return render::frame(document, camera, view);
    };
    const auto still = render::draw_still(*context(), source, numbers, frame_of,
                                          render::whole(width, height), outputs);
    if (!still) {
        ADD_FAILURE() << scene.name << " by " << variant.name << ": " << text_of(still.problems());
        return {};
    }
    return shot_of(*still);
}

oracle::Reference trace(const Scene& scene, int width, int height) {
    oracle::Query query;
    query.width = width;
    query.height = height;
    auto reference = oracle::trace(scene.formula, scene.document, query);
    if (!reference) {
        ADD_FAILURE() << scene.name << ": " << text_of(reference.problems());
        return {};
    }
    return std::move(*reference);
}

}  // namespace torture
