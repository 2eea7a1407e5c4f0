// SPDX-License-Identifier: MIT
// A linked program that is drawn again and again.
#pragma once

#include <vector>

#include "base/result.h"
#include "render/canvas.h"
#include "render/context.h"
#include "render/program.h"
#include "shader/field_numbers.h"

namespace bench {

/// With the numbers that it is fed with besides the frame.
struct KeptProgram {
    render::Program program;
    shader::FieldNumbers numbers;
    double link_seconds = 0;
};

/// Error: the driver rejects the program.
base::Result<KeptProgram> keep(render::Context& context, const shader::ProgramSource& source,
                               shader::FieldNumbers numbers);

/// Draws the whole canvas; the seconds from the draw until everything is there.
double timed_draw(render::Canvas& canvas, const KeptProgram& kept, const render::Frame& frame);

}  // namespace bench
