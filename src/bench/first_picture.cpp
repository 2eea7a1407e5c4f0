// SPDX-License-Identifier: MIT
#include "bench/first_picture.h"

#include <chrono>
#include <utility>
#include <vector>

#include "bench/statistics.h"
#include "compile/compile.h"

namespace bench {

BeforeLinking before_linking(const Subject& subject, const shader::Outputs& outputs) {
    using Clock = std::chrono::steady_clock;
    const auto since = [](Clock::time_point start) {
        return std::chrono::duration<double>(Clock::now() - start).count();
    };
    const Clock::time_point start = Clock::now();
    const auto formula = compile::compile_formula(subject.document.formula);
    BeforeLinking result;
    result.parse_seconds = since(start);
    scene::Document own = subject.document;
    own.settings.tracer = "auto";
    std::vector<double> seconds;
    for (int i = 0; i < 5 && (seconds.empty() || seconds[0] < slow_seconds); ++i) {
        const Clock::time_point begin = Clock::now();
        const auto source = compile::program_source(subject.formula, own, outputs);
        compile::field_numbers(subject.formula, source, own);
        seconds.push_back(since(begin));
    }
    result.analyse_seconds = quantile(seconds, 0.5);
    return result;
}

base::Result<FirstPicture> first_picture(render::Context& context, render::Canvas& canvas,
                                         const shader::ProgramSource& source,
                                         const shader::FieldNumbers& numbers,
                                         const render::Frame& frame, int times) {
    std::vector<double> links, frames;
    for (int i = 0; i < times; ++i) {
        auto program = keep(context, source, numbers);
        if (!program) return program.problems();
        links.push_back(program->link_seconds);
        frames.push_back(timed_draw(canvas, *program, frame));
    }
    return FirstPicture{quantile(links, 0.5), quantile(frames, 0.5)};
}

}  // namespace bench
