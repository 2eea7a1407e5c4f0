// SPDX-License-Identifier: MIT
#include "bench/kept_program.h"

#include <chrono>
#include <utility>

namespace bench {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

base::Result<KeptProgram> keep(render::Context& context, const shader::ProgramSource& source,
                               shader::FieldNumbers numbers) {
    const Clock::time_point start = Clock::now();
    auto program = render::Program::link(context.gl(), source);
    if (!program) return program.problems();
    return KeptProgram{std::move(*program), std::move(numbers), seconds_since(start)};
}

double timed_draw(render::Canvas& canvas, const KeptProgram& kept, const render::Frame& frame) {
    canvas.finish();
    const Clock::time_point start = Clock::now();
    canvas.draw(kept.program, frame, kept.numbers, {0, 0, canvas.width(), canvas.height()});
    canvas.finish();
    return seconds_since(start);
}

}  // namespace bench
