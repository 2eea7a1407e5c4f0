// SPDX-License-Identifier: MIT
// The thread that compiles formulas, links programs, draws screenshots and trials, so that the user
// interface never waits for them.
#pragma once

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "base/result.h"
#include "render/context.h"
#include "scene/document.h"
#include "studio/scene_builder.h"
#include "studio/trial_canvas.h"

namespace studio {

/// A picture to be drawn into a PNG file, of the formula that is on show.
struct StillRequest {
    scene::Document document;
    scene::Camera camera;
    int width = 1920, height = 1080;
    std::filesystem::path file;
};

struct StillAnswer {
    std::filesystem::path file;
    base::Status status;
    double seconds = 0;
};

/// Owns a thread with a context of its own, which shares objects with the window's. Of several
/// requests for a scene or a trial only the newest is answered; pictures are all drawn, between
/// scenes. Trials come last.
class CompilerThread {
public:
    enum class Activity { idle, compiling, drawing_still, drawing_trial };

    /// The context must not be current anywhere, and must outlive the thread. `wake` is called on
    /// the thread when there is an answer.
    CompilerThread(render::Context& context, std::function<void()> wake);
    /// Waits until the work at hand is done; what has not been begun is dropped.
    ~CompilerThread();
    CompilerThread(const CompilerThread&) = delete;
    CompilerThread& operator=(const CompilerThread&) = delete;

    void request(const scene::Document& document);
    void request_still(StillRequest still);
    void request_trial(TrialRequest trial);

    /// The newest scene, once; one whose analyses had to be cut short comes again when nothing else
    /// has been asked for a while. Everything the thread's context did for it is complete.
    std::optional<BuiltScene> take_scene();
    std::vector<StillAnswer> take_stills();
    /// The newest answer, once. A trial is given up for anything else that is asked for.
    std::optional<TrialAnswer> take_trial();
    Activity activity() const;

private:
    void run();
    bool serve();
    bool something_is_urgent() const;
    void draw_still(std::unique_lock<std::mutex>& lock);
    void draw_trial(std::unique_lock<std::mutex>& lock);
    void build(const scene::Document& document);
    void refine();
    void publish(BuiltScene scene);
    base::Status draw(const StillRequest& still);

    render::Context& context_;
    std::function<void()> wake_;
    SceneBuilder builder_;
    std::optional<scene::Document> coarse_;    ///< what is to be analysed again, with more time
    std::optional<TrialCanvas> trial_canvas_;  ///< used and destroyed on the thread

    mutable std::mutex mutex_;  ///< guards everything below
    std::condition_variable wanted_;
    bool stop_ = false;
    Activity activity_ = Activity::idle;
    std::optional<scene::Document> request_;
    std::deque<StillRequest> still_requests_;
    std::optional<BuiltScene> scene_;
    std::vector<StillAnswer> still_answers_;
    std::optional<TrialRequest> trial_request_;
    std::optional<TrialAnswer> trial_answer_;

    std::thread thread_;
};

}  // namespace studio
