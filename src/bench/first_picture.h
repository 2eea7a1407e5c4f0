// SPDX-License-Identifier: MIT
// How long a person waits for the first picture of a new text.
#pragma once

#include "base/result.h"
#include "bench/kept_program.h"
#include "bench/subject.h"
#include "render/canvas.h"
#include "render/context.h"
#include "render/frame.h"
#include "shader/program_source.h"

namespace bench {

/// What takes longer, in seconds, shows itself at once and is measured once.
inline constexpr double slow_seconds = 1;

/// Seconds.
struct BeforeLinking {
    double parse_seconds = 0;
    double analyse_seconds = 0;  ///< with writing the program; the median of five times
};

/// Of the tracer auto with the subject's own settings.
BeforeLinking before_linking(const Subject& subject, const shader::Outputs& outputs);

/// Seconds, medians over the times that it was done.
struct FirstPicture {
    double link_seconds = 0;
    double first_frame_seconds = 0;  ///< the driver compiles in it, too
};

/// Links the program anew so many times, and draws one frame with each. The driver must keep no
/// programs (MESA_SHADER_CACHE_DISABLE=true), or all but the first time are short.
base::Result<FirstPicture> first_picture(render::Context& context, render::Canvas& canvas,
                                         const shader::ProgramSource& source,
                                         const shader::FieldNumbers& numbers,
                                         const render::Frame& frame, int times);

}  // namespace bench
