// SPDX-License-Identifier: MIT
#include "studio/trial_canvas.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <utility>

#include <fmt/format.h>

#include "render/frame.h"

namespace studio {
namespace {

using Clock = std::chrono::steady_clock;

/// As a picture that is drawn once: a trial has no passes to keep.
constexpr shader::Outputs trial_outputs{.picture = true, .geometry = true};
constexpr std::size_t most_programs = 24;
constexpr double band_seconds = 0.1;
constexpr int first_rows = 32;  // of a picture whose cost is not known yet
constexpr int least_rows = 8;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The rows that are drawn between two looks at whether something else is more urgent.
int rows_at_once(int height, double expected_seconds) {
    if (!(expected_seconds > 0)) return first_rows;
    const double rows = height * band_seconds / expected_seconds;
    return static_cast<int>(std::clamp<double>(rows, least_rows, std::max(height, least_rows)));
}

oracle::Shot shot_of(const image::Image<float, 4>& geometry) {
    oracle::Shot shot;
    shot.depth = image::Grey(geometry.width, geometry.height);
    const std::size_t count = shot.depth.values.size();
    shot.gave_up.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const float* pixel = &geometry.values[4 * i];
        shot.depth.values[i] = pixel[0];
        shot.gave_up[i] = std::lround(pixel[2]) == static_cast<long>(shader::Status::unresolved);
    }
    return shot;
}

base::Result<std::shared_ptr<const Judged>> judge(const oracle::Reference& reference,
                                                  const image::Image<float, 4>& geometry) {
    auto metrics = oracle::compare(reference, shot_of(geometry));
    if (!metrics) return metrics.problems();
    auto areas = marked_areas(reference, *metrics);
    metrics->judgements = {};
    return std::make_shared<const Judged>(Judged{std::move(*metrics), std::move(areas)});
}

}  // namespace

TrialAnswer TrialCanvas::draw(const TrialRequest& trial, const std::function<bool()>& superseded) {
    TrialAnswer answer{.id = trial.id};
    try {
        if (auto status = draw(trial, superseded, answer); !status) {
            answer.problems = status.problems();
        }
    } catch (const std::exception& exception) {
        answer.problems = {
            base::error(fmt::format("internal error while judging: {}", exception.what()))};
    }
    return answer;
}

base::Status TrialCanvas::draw(const TrialRequest& trial, const std::function<bool()>& superseded,
                               TrialAnswer& answer) {
    const int width = trial.reference->width, height = trial.reference->height;
    if (auto status = fit(width, height); !status) return status;
    const shader::ProgramSource source =
        compile::program_source(*trial.formula, trial.document, trial_outputs);
    const auto linked = program(source);
    if (!linked) return linked.problems();
    const shader::FieldNumbers numbers =
        compile::field_numbers(*trial.formula, source, trial.document);
    const render::Frame frame =
        render::frame(trial.document, scene::camera_of(trial.document, double(width) / height),
                      render::whole(width, height));
    const int rows = rows_at_once(height, trial.expected_seconds);
    const Clock::time_point start = Clock::now();
    for (int y = 0; y < height; y += rows) {
        answer.given_up = superseded();
        if (answer.given_up) return base::Done{};
        canvas_->draw(**linked, frame, numbers, {0, y, width, std::min(rows, height - y)});
        canvas_->finish();
    }
    answer.seconds = seconds_since(start);
    if (!trial.judged) return base::Done{};
    auto judged = judge(*trial.reference, canvas_->read_geometry());
    if (!judged) return judged.problems();
    answer.judged = std::move(*judged);
    return base::Done{};
}

base::Result<const render::Program*> TrialCanvas::program(const shader::ProgramSource& source) {
    const std::string text = source.prepass + source.fragment;
    const auto known = programs_.find(text);
    if (known != programs_.end()) return &known->second;
    if (programs_.size() >= most_programs) programs_.clear();
    auto linked = render::Program::link(*gl_, source);
    if (!linked) return linked.problems();
    return &programs_.emplace(text, std::move(*linked)).first->second;
}

base::Status TrialCanvas::fit(int width, int height) {
    if (canvas_ && canvas_->width() == width && canvas_->height() == height) return base::Done{};
    canvas_.reset();
    auto made = render::Canvas::create(*gl_, width, height, trial_outputs);
    if (!made) return made.problems();
    canvas_ = std::move(*made);
    return base::Done{};
}

}  // namespace studio
