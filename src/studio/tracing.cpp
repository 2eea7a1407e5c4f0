// SPDX-License-Identifier: MIT
#include "studio/tracing.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "shader/program_source.h"

namespace studio {
namespace {

constexpr double scales[] = {0.25, 0.5, 0.7, 1, 1.4, 2};

}  // namespace

Tracing tracing_of(const scene::Settings& settings) {
    return {settings.tracer, settings.lipschitz, settings.steps, settings.epsilon};
}

void apply(const Tracing& tracing, scene::Settings& settings) {
    settings.tracer = tracing.tracer;
    settings.lipschitz = tracing.lipschitz;
    settings.steps = tracing.steps;
    settings.epsilon = tracing.epsilon;
}

std::vector<Tracing> neighbours(const Tracing& present) {
    std::vector<Tracing> list{present};
    const auto add = [&](std::string tracer, double lipschitz) {
        Tracing tracing{std::move(tracer), lipschitz, present.steps, present.epsilon};
        if (std::ranges::find(list, tracing) == list.end()) list.push_back(std::move(tracing));
    };
    for (const double scale : scales) add(present.tracer, scale);
    for (const shader::TracerName& tracer : shader::tracers()) {
        if (tracer.name != present.tracer) add(std::string(tracer.name), 1);
    }
    return list;
}

std::string describe(const Tracing& tracing) {
    return fmt::format("{}, Lipschitz scale {:.4g}", tracing.tracer, tracing.lipschitz);
}

}  // namespace studio
