// SPDX-License-Identifier: MIT
// Measuring one scene: how long each tracer takes with each setting, and how wrong it is.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bench/report.h"
#include "bench/subject.h"
#include "image/image.h"
#include "render/context.h"

namespace bench {

struct Options {
    std::vector<std::string> tracers;  ///< names of shader::tracers()
    std::vector<Sweep> sweeps;
    int width = 640;
    int height = 480;
    int rounds = 7;
    std::uint32_t seed = 1;
    std::vector<std::string> passes;  ///< tracers whose passes are told apart
};

/// All programs of a scene are linked once and kept; then, round after round, every configuration
/// draws one frame, in another order each round. The context must be current. Errors: no memory, a
/// program that the driver rejects.
base::Result<PresetReport> measure(render::Context& context, const Subject& subject,
                                   const Options& options);

}  // namespace bench
