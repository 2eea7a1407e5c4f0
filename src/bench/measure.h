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
#include "oracle/reference.h"
#include "render/context.h"

namespace bench {

struct Options {
    std::vector<std::string> tracers;  ///< names of shader::tracers()
    std::vector<Sweep> sweeps;
    int width = 640;
    int height = 480;
    int rounds = 7;
    /// Of the pictures that are held against the reference: errors are not counted at the size that
    /// is timed, for which a reference would take far longer than all else.
    int reference_width = 320;
    int reference_height = 240;
    std::uint32_t seed = 1;
    std::vector<std::string> passes;  ///< tracers whose passes are told apart
};

/// Where a tracer at the preset's own settings is wrong (oracle::marked_picture).
struct MarkedPicture {
    std::string tracer;
    image::Picture picture;
};

struct Measured {
    PresetReport report;
    std::vector<MarkedPicture> pictures;  ///< none without a reference
};

/// All programs of a scene are linked once and kept: one for each tracer, the shaders by hand that
/// are meant for it, and the limit. Then, round after round, every configuration draws one frame,
/// in another order each round; those that take longer than a second only in the
/// first three rounds. Without a reference (null) errors are left open, and the limit is
/// told the depths of `auto`. The context must be current. Errors: no memory, a program that the
/// driver rejects, a reference of another size than the options say.
///
/// Scenes are measured one after the other, not all side by side: llvmpipe keeps no more than 1024
/// programs or 2 million of their instructions, and would compile the rest again in every round.
base::Result<Measured> measure(render::Context& context, const Subject& subject,
                               const Options& options, const oracle::Reference* reference);

}  // namespace bench
