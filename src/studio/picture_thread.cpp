// SPDX-License-Identifier: MIT
#include "studio/picture_thread.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "render/frame.h"
#include "studio/live_outputs.h"

namespace studio {
namespace {

/// Between two looks at whether somebody waits, or wants something else.
constexpr double seconds_at_once = PictureScheduler::tile_seconds;
/// Showing each tile at once would take longer than drawing it.
constexpr double seconds_between_tiles = 0.08;
constexpr double longest_wait = 3600;

double clock_seconds() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

}  // namespace

PictureThread::Shown::Shown(PictureThread& thread) : thread_(&thread) {
    ++thread.waiting_;
    lock_ = std::unique_lock(thread.canvases_);
    --thread.waiting_;
}

PictureThread::Shown::~Shown() {
    lock_.unlock();
    thread_->free_.notify_one();
}

PictureThread::PictureThread(render::Context& context, std::function<void()> wake)
    : context_(context), wake_(std::move(wake)) {
    picture_.emplace(context_.gl());
    thread_ = std::thread([this] { run(); });
}

PictureThread::~PictureThread() {
    {
        const std::lock_guard lock(mail_);
        stop_ = true;
    }
    news_for_thread_.notify_one();
    thread_.join();
}

void PictureThread::set_program(std::unique_ptr<render::Program> program,
                                shader::FieldNumbers numbers) {
    {
        const std::lock_guard lock(mail_);
        program_ = NewProgram{std::move(program), std::move(numbers)};
        complete_ = false;
    }
    news_for_thread_.notify_one();
}

void PictureThread::want(WantedPicture wanted) {
    {
        const std::lock_guard lock(mail_);
        wanted_ = std::move(wanted);
        complete_ = false;
    }
    news_for_thread_.notify_one();
}

base::Result<bool> PictureThread::take_news() {
    const std::lock_guard lock(mail_);
    if (!problems_.empty()) return std::exchange(problems_, {});
    return std::exchange(something_to_show_, false);
}

void PictureThread::run() {
    context_.make_current();
    while (serve()) {
    }
    program_.reset();
    picture_.reset();
    context_.release();
}

/// Waits until there is something to do, and does some of it. False when the thread shall end.
bool PictureThread::serve() {
    std::unique_lock lock(mail_);
    const double seconds = std::min(picture_->wait(clock_seconds()), longest_wait);
    news_for_thread_.wait_for(lock, std::chrono::duration<double>(seconds),
                              [&] { return stop_ || program_ || wanted_; });
    if (stop_) return false;
    std::optional<NewProgram> fresh = std::exchange(program_, std::nullopt);
    const std::optional<WantedPicture> wanted = std::exchange(wanted_, std::nullopt);
    lock.unlock();
    base::Status warmed = base::Done{};
    if (fresh) warmed = warm(*fresh);
    if (warmed) {
        publish(draw(fresh ? std::move(fresh->program) : nullptr, wanted));
    } else {
        publish(warmed.problems());
    }
    return true;
}

/// Draws a few pixels aside: drivers translate a program when it is used for the first time, and
/// meanwhile the window shows what there is.
base::Status PictureThread::warm(const NewProgram& fresh) {
    constexpr int size = 16;
    auto canvas = render::Canvas::create(context_.gl(), size, size, live_outputs);
    if (!canvas) return canvas.problems();
    const render::Frame frame =
        render::frame({}, scene::camera_of({}, 1), render::whole(size, size));
    canvas->draw(*fresh.program, frame, fresh.numbers, {0, 0, size, size});
    canvas->finish();
    return base::Done{};
}

base::Result<PictureNews> PictureThread::draw(std::unique_ptr<render::Program> program,
                                              const std::optional<WantedPicture>& wanted) {
    std::unique_lock lock(canvases_);
    free_.wait(lock, [&] { return waiting_ == 0; });
    if (program) picture_->set_program(std::move(program), clock_seconds());
    if (wanted) picture_->want(*wanted, clock_seconds());
    return picture_->work(seconds_at_once, clock_seconds());
}

void PictureThread::publish(const base::Result<PictureNews>& news) {
    const double now = clock_seconds();
    {
        const std::lock_guard lock(mail_);
        const bool was_complete = complete_;
        complete_ = picture_->complete() && !program_ && !wanted_;
        const bool worth_showing =
            !news || *news == PictureNews::whole || (complete_ && !was_complete) ||
            (*news == PictureNews::tiles && now - shown_ > seconds_between_tiles);
        if (!worth_showing) return;
        if (!news) problems_ = news.problems();
        something_to_show_ = true;
        shown_ = now;
    }
    wake_();
}

}  // namespace studio
