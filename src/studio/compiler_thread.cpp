// SPDX-License-Identifier: MIT
#include "studio/compiler_thread.h"

#include <chrono>
#include <exception>
#include <utility>

#include <fmt/format.h>

#include "compile/compile.h"
#include "image/png.h"
#include "render/frame.h"
#include "render/still.h"

namespace studio {
namespace {

/// A slider that has not moved for so long is at rest.
constexpr std::chrono::milliseconds rest(100);

base::Result<std::unique_ptr<render::Program>> link(const render::Gl& gl,
                                                    const shader::ProgramSource& source) {
    auto linked = render::Program::link(gl, source);
    if (!linked) return linked.problems();
    return std::make_unique<render::Program>(std::move(*linked));
}

/// Later news win, but a program that has not been taken yet must not get lost.
void merge(std::optional<BuiltScene>& old, BuiltScene scene) {
    if (old && !scene.program) scene.program = std::move(old->program);
    if (old && !scene.parameters) scene.parameters = std::move(old->parameters);
    if (old && !scene.field_numbers) {
        scene.field_numbers = std::move(old->field_numbers);
        scene.bounds = old->bounds;
        scene.steps = std::move(old->steps);
        scene.precision = old->precision;
    }
    old = std::move(scene);
}

}  // namespace

CompilerThread::CompilerThread(render::Context& context, std::function<void()> wake)
    : context_(context),
      wake_(std::move(wake)),
      builder_([this](const shader::ProgramSource& source) { return link(context_.gl(), source); }),
      thread_([this] { run(); }) {}

CompilerThread::~CompilerThread() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    wanted_.notify_one();
    thread_.join();
}

void CompilerThread::request(const scene::Document& document) {
    {
        const std::lock_guard lock(mutex_);
        request_ = document;
    }
    wanted_.notify_one();
}

void CompilerThread::request_still(StillRequest still) {
    {
        const std::lock_guard lock(mutex_);
        still_requests_.push_back(std::move(still));
    }
    wanted_.notify_one();
}

void CompilerThread::request_trial(TrialRequest trial) {
    {
        const std::lock_guard lock(mutex_);
        trial_request_ = std::move(trial);
    }
    wanted_.notify_one();
}

std::optional<BuiltScene> CompilerThread::take_scene() {
    const std::lock_guard lock(mutex_);
    return std::exchange(scene_, std::nullopt);
}

std::vector<StillAnswer> CompilerThread::take_stills() {
    const std::lock_guard lock(mutex_);
    return std::exchange(still_answers_, {});
}

std::optional<TrialAnswer> CompilerThread::take_trial() {
    const std::lock_guard lock(mutex_);
    return std::exchange(trial_answer_, std::nullopt);
}

CompilerThread::Activity CompilerThread::activity() const {
    const std::lock_guard lock(mutex_);
    const bool gives_way = activity_ == Activity::idle || activity_ == Activity::drawing_trial;
    if (gives_way && request_) return Activity::compiling;
    if (gives_way && !still_requests_.empty()) return Activity::drawing_still;
    return activity_;
}

void CompilerThread::run() {
    context_.make_current();
    trial_canvas_.emplace(context_.gl());
    while (serve()) wake_();
    trial_canvas_.reset();
    context_.release();
}

/// Waits for one request and answers it. False when the thread shall end.
bool CompilerThread::serve() {
    std::unique_lock lock(mutex_);
    activity_ = Activity::idle;
    if (coarse_ && !wanted_.wait_for(lock, rest, [&] { return something_is_urgent(); })) {
        activity_ = Activity::compiling;
        lock.unlock();
        refine();
        lock.lock();
        activity_ = Activity::idle;
        return true;
    }
    wanted_.wait(lock, [&] { return something_is_urgent() || trial_request_; });
    if (stop_) return false;
    if (request_) {
        activity_ = Activity::compiling;
        const scene::Document document = *std::exchange(request_, std::nullopt);
        lock.unlock();
        build(document);
        lock.lock();
    } else if (!still_requests_.empty()) {
        draw_still(lock);
    } else {
        draw_trial(lock);
    }
    activity_ = Activity::idle;
    return true;
}

bool CompilerThread::something_is_urgent() const {
    return stop_ || request_ || !still_requests_.empty();
}

void CompilerThread::draw_still(std::unique_lock<std::mutex>& lock) {
    activity_ = Activity::drawing_still;
    const StillRequest still = std::move(still_requests_.front());
    still_requests_.pop_front();
    lock.unlock();
    const auto start = std::chrono::steady_clock::now();
    base::Status status = draw(still);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    lock.lock();
    still_answers_.push_back({still.file, std::move(status), spent.count()});
}

void CompilerThread::draw_trial(std::unique_lock<std::mutex>& lock) {
    activity_ = Activity::drawing_trial;
    const TrialRequest trial = *std::exchange(trial_request_, std::nullopt);
    lock.unlock();
    TrialAnswer answer = trial_canvas_->draw(trial, [this] {
        const std::lock_guard guard(mutex_);
        return something_is_urgent();
    });
    lock.lock();
    trial_answer_ = std::move(answer);
}

void CompilerThread::build(const scene::Document& document) {
    const auto superseded = [&] {
        const std::lock_guard lock(mutex_);
        return stop_ || (request_ && request_->formula != document.formula);
    };
    const analysis::Budget budget = analysis::Budget::of_seconds(analysis::frame_seconds);
    auto built = builder_.build(document, superseded, &budget);
    coarse_.reset();
    if (!built) return;
    if (builder_.is_coarse()) coarse_ = document;
    // The other context may use a program only once the commands that made it are done.
    context_.gl().Finish();
    publish(std::move(*built));
}

/// Does for a slider at rest what there was no time for; given up for anything that is urgent.
void CompilerThread::refine() {
    const auto urgent = [this] {
        const std::lock_guard lock(mutex_);
        return something_is_urgent();
    };
    const analysis::Budget budget(urgent);
    auto built = builder_.build(*coarse_, urgent, &budget);
    if (!built || builder_.is_coarse()) return;
    coarse_.reset();
    publish(std::move(*built));
}

void CompilerThread::publish(BuiltScene scene) {
    const std::lock_guard lock(mutex_);
    merge(scene_, std::move(scene));
}

base::Status CompilerThread::draw(const StillRequest& still) {
    try {
        const compile::Formula* formula = builder_.formula();
        if (!formula) {
            return base::error("there is no picture yet; correct the formula, and try again");
        }
        constexpr shader::Outputs outputs{.picture = true};
        const shader::ProgramSource source =
            compile::program_source(*formula, still.document, outputs);
        const shader::FieldNumbers numbers =
            compile::field_numbers(*formula, source, still.document);
        const auto frame_of = [&](const render::View& view) {
            return render::frame(still.document, still.camera, view);
        };
        auto drawn = render::draw_still(context_, source, numbers, frame_of,
                                        render::whole(still.width, still.height), outputs);
        if (!drawn) return drawn.problems();
        return image::write_png(still.file, drawn->picture);
    } catch (const std::exception& exception) {
        return base::error(fmt::format("internal error while drawing: {}", exception.what()));
    }
}

}  // namespace studio
