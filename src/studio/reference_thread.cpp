// SPDX-License-Identifier: MIT
#include "studio/reference_thread.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include <fmt/format.h>

namespace studio {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::int64_t report_milliseconds = 100;

/// One core is left to the window.
int thread_count() {
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
}

std::int64_t milliseconds() {
    const auto now = Clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::milliseconds>(now).count();
}

}  // namespace

ReferenceThread::ReferenceThread(Trace trace, std::function<void()> wake)
    : trace_(std::move(trace)), wake_(std::move(wake)), thread_([this] { run(); }) {}

ReferenceThread::~ReferenceThread() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
        ++turn_;
    }
    wanted_.notify_one();
    thread_.join();
}

void ReferenceThread::start(ReferenceKey key) {
    {
        const std::lock_guard lock(mutex_);
        ++turn_;
        progress_ = 0;
        request_ = std::move(key);
        answer_.reset();
        busy_ = true;
    }
    wanted_.notify_one();
}

void ReferenceThread::cancel() {
    const std::lock_guard lock(mutex_);
    ++turn_;
    request_.reset();
    answer_.reset();
    busy_ = false;
}

bool ReferenceThread::busy() const {
    const std::lock_guard lock(mutex_);
    return busy_;
}

std::optional<TracedReference> ReferenceThread::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(answer_, std::nullopt);
}

void ReferenceThread::run() {
    std::unique_lock lock(mutex_);
    while (true) {
        wanted_.wait(lock, [&] { return stop_ || request_; });
        if (stop_) return;
        ReferenceKey key = *std::exchange(request_, std::nullopt);
        const std::uint64_t turn = turn_;
        lock.unlock();
        TracedReference answer = trace(std::move(key), turn);
        lock.lock();
        if (turn != turn_) continue;
        answer_ = std::move(answer);
        busy_ = false;
        lock.unlock();
        wake_();
        lock.lock();
    }
}

TracedReference ReferenceThread::trace(ReferenceKey key, std::uint64_t turn) {
    const Clock::time_point start = Clock::now();
    TracedReference answer{.key = std::move(key)};
    try {
        auto formula = compile::compile_formula(answer.key.scene.formula);
        if (!formula) {
            answer.problems = formula.problems();
            return answer;
        }
        answer.formula = std::make_shared<const compile::Formula>(std::move(*formula));
        auto traced = trace_(*answer.formula, answer.key.scene,
                             {.width = answer.key.width,
                              .height = answer.key.height,
                              .region = std::nullopt,
                              .threads = thread_count(),
                              .progress = [&](double part) { return report(part, turn); }});
        answer.problems = traced.problems();
        if (traced)
            answer.reference = std::make_shared<const oracle::Reference>(std::move(*traced));
    } catch (const std::exception& exception) {
        answer.problems.push_back(
            base::error(fmt::format("internal error while checking: {}", exception.what())));
    }
    answer.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return answer;
}

/// False if the work at hand is not wanted any more.
bool ReferenceThread::report(double part, std::uint64_t turn) {
    if (turn != turn_) return false;
    progress_ = part;
    const std::int64_t now = milliseconds();
    std::int64_t last = reported_;
    if (now - last >= report_milliseconds && reported_.compare_exchange_strong(last, now)) wake_();
    return true;
}

}  // namespace studio
