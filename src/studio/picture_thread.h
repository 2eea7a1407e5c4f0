// SPDX-License-Identifier: MIT
// The thread that draws the live picture, so that the interface waits neither for a driver that
// translates a program nor for a slow scene.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "base/result.h"
#include "render/context.h"
#include "studio/live_picture.h"

namespace studio {

/// Owns a thread with a context of its own, which shares textures with the window's and programs
/// with the compiler's. Drivers translate a program for each context that draws with it: this is
/// the only one. While a new program is being translated the old picture stands still.
class PictureThread {
public:
    /// What there is to show. The thread draws nothing, so the textures stay as they are, for as
    /// long as this lives.
    class Shown {
    public:
        ~Shown();
        Shown(const Shown&) = delete;
        Shown& operator=(const Shown&) = delete;

        PictureLayers layers() const { return thread_->picture_->layers(); }
        const std::optional<PictureReport>& report() const { return thread_->picture_->report(); }

    private:
        friend PictureThread;
        explicit Shown(PictureThread& thread);

        PictureThread* thread_;
        std::unique_lock<std::mutex> lock_;
    };

    /// The context must not be current anywhere, and must outlive the thread. `wake` is called on
    /// the thread when there is something new.
    PictureThread(render::Context& context, std::function<void()> wake);
    ~PictureThread();
    PictureThread(const PictureThread&) = delete;
    PictureThread& operator=(const PictureThread&) = delete;

    /// The program of all further pictures, and numbers that fit it.
    void set_program(std::unique_ptr<render::Program> program, shader::FieldNumbers numbers);
    /// Says what is to be drawn; only the newest wish counts.
    void want(WantedPicture wanted);

    /// Waits for the tile at hand.
    Shown show() { return Shown(*this); }
    /// True if the full picture of what is wanted is there.
    bool complete() const { return complete_; }
    /// Whether there is something new to show since the last call; or what went wrong.
    base::Result<bool> take_news();

private:
    struct NewProgram {
        std::unique_ptr<render::Program> program;
        shader::FieldNumbers numbers;
    };

    void run();
    bool serve();
    base::Status warm(const NewProgram& fresh);
    base::Result<PictureNews> draw(std::unique_ptr<render::Program> program,
                                   const std::optional<WantedPicture>& wanted);
    void publish(const base::Result<PictureNews>& news);

    render::Context& context_;
    std::function<void()> wake_;

    std::mutex canvases_;  ///< guards the picture
    std::condition_variable free_;
    std::atomic<int> waiting_ = 0;        ///< for the picture
    std::optional<LivePicture> picture_;  ///< made and destroyed on the thread

    std::mutex mail_;  ///< guards everything below
    std::condition_variable news_for_thread_;
    bool stop_ = false;
    std::optional<NewProgram> program_;
    std::optional<WantedPicture> wanted_;
    bool something_to_show_ = false;
    base::Diagnostics problems_;
    std::atomic<bool> complete_ = true;
    double shown_ = 0;  ///< when there was something to show last

    std::thread thread_;
};

}  // namespace studio
