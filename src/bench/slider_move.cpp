// SPDX-License-Identifier: MIT
#include "bench/slider_move.h"

#include <algorithm>
#include <chrono>
#include <vector>

#include "bench/statistics.h"
#include "compile/check_scene.h"
#include "compile/precision.h"
#include "compile/step_rules.h"

namespace bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int times = 6;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

bool is_number(const field::Parameter& parameter) {
    using Type = field::ParameterType;
    return parameter.type == Type::real || parameter.type == Type::logarithmic ||
           parameter.type == Type::angle;
}

}  // namespace

std::optional<SliderMove> move_slider(const compile::Formula& formula,
                                      const shader::ProgramSource& source,
                                      const scene::Document& document,
                                      const std::function<void(shader::FieldNumbers)>& draw) {
    const auto parameter = std::ranges::find_if(formula.field.parameters, is_number);
    if (parameter == formula.field.parameters.end()) return std::nullopt;
    scene::Document moved = document;
    const double step = (parameter->maximum - parameter->minimum) / 100;
    SliderMove result;
    std::vector<double> before, whole;
    for (int i = 0; i < times; ++i) {
        auto components = compile::components_in(document, *parameter);
        // Never where it just was.
        components[0] += (i % 2 == 0 ? 1 : -1) * (1 + 0.01 * i) * step;
        compile::set_components(moved, *parameter, components);
        const Clock::time_point start = Clock::now();
        compile::check_scene(formula, moved);
        compile::choose_precision(formula, moved);
        const analysis::Budget budget = analysis::Budget::of_seconds(analysis::frame_seconds);
        shader::FieldNumbers numbers = compile::field_numbers(formula, source, moved, &budget);
        compile::step_rules(formula.field, source, numbers, moved);
        result.coarse = result.coarse || numbers.coarse;
        before.push_back(seconds_since(start));
        draw(std::move(numbers));
        whole.push_back(seconds_since(start));
    }
    result.before_seconds = quantile(before, 0.5);
    result.picture_seconds = quantile(whole, 0.5);
    return result;
}

}  // namespace bench
