// SPDX-License-Identifier: MIT
#include "studio/event_loop.h"

#include <algorithm>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "compile/precision.h"
#include "oracle/trace.h"
#include "studio/actions.h"
#include "studio/document_file.h"
#include "studio/layout.h"
#include "studio/shortcuts.h"

namespace studio {
namespace {

constexpr double longest_wait = 2;
constexpr double accuracy_news_seconds = 0.2;
constexpr double blink_seconds = 0.2;  // of the text cursor
/// Dear ImGui needs a few frames until everything has found its place.
constexpr int frames_after_event = 3;

/// What the compiler reads of a document.
bool compiles_alike(const scene::Document& a, const scene::Document& b) {
    return a.formula == b.formula && a.parameters == b.parameters && a.time == b.time &&
           a.bounds == b.bounds && a.settings == b.settings && compile::look_alike(a, b);
}

/// The window behind a dialog is being darkened or lit up again.
bool is_fading() {
    const float ratio = ImGui::GetCurrentContext()->DimBgRatio;
    return ratio > 0 && ratio < 1;
}

}  // namespace

EventLoop::EventLoop(Window& window, const Options& options)
    : window_(window),
      workspace_(first_document()),
      gui_(window),
      input_(window.handle()),
      picture_(window.picture_context(), &Window::wake),
      compiler_(window.compiler_context(), &Window::wake),
      accuracy_(workspace_.accuracy, oracle::trace, &Window::wake) {
    workspace_.renderer = window.context().renderer();
    workspace_.presets = list_all_presets();
    if (options.preset) {
        if (auto status = open_file(workspace_, *options.preset); !status) {
            workspace_.report_problems(status.problems());
        }
    }
    workspace_.dialogs.recovered = autosave_.recover();
    if (workspace_.dialogs.recovered) workspace_.dialogs.show(Dialogs::Kind::recover);
}

bool EventLoop::step() {
    window_.handle_events(wait_seconds());
    if (input_.has_news()) frames_to_draw_ = frames_after_event;
    if (window_.wants_to_close()) {
        window_.stay_open();
        if (!workspace_.dialogs.open()) start(workspace_, {PendingAction::Kind::quit, {}});
    }
    take_answers();
    look_at_picture();
    look_at_accuracy();
    const bool blinks = ImGui::GetIO().WantTextInput && glfwGetTime() - last_frame_ > blink_seconds;
    if (workspace_.playback.playing || blinks) frames_to_draw_ = std::max(frames_to_draw_, 1);
    if (is_fading()) frames_to_draw_ = std::max(frames_to_draw_, 1);
    if (frames_to_draw_ > 0) {
        --frames_to_draw_;
        draw_interface();
    }
    start_trial();
    keep_safe();
    return !workspace_.quit;
}

double EventLoop::wait_seconds() const {
    if (frames_to_draw_ > 0 || input_.has_news() || workspace_.playback.playing) return 0;
    const double now = glfwGetTime();
    double seconds = std::min({longest_wait, autosave_.wait(now), accuracy_.wait(now)});
    if (ImGui::GetIO().WantTextInput) seconds = std::min(seconds, blink_seconds);
    return seconds;
}

void EventLoop::take_answers() {
    Compilation& compilation = workspace_.compilation;
    if (auto scene = compiler_.take_scene()) {
        compilation.text = std::move(scene->text);
        compilation.diagnostics = std::move(scene->diagnostics);
        compilation.failures = std::move(scene->failures);
        if (scene->parameters) compilation.parameters = std::move(*scene->parameters);
        if (scene->field_numbers) {
            compilation.field_numbers = std::move(*scene->field_numbers);
            compilation.bounds = scene->bounds;
            compilation.steps = std::move(scene->steps);
            compilation.precision = scene->precision;
            compilation.drawable = true;
        }
        if (scene->program)
            picture_.set_program(std::move(scene->program), compilation.field_numbers);
        ask_for_picture();
        frames_to_draw_ = frames_after_event;
    }
    for (const StillAnswer& still : compiler_.take_stills()) {
        if (still.status) {
            workspace_.note(
                fmt::format("wrote '{}' in {:.1f} s", still.file.string(), still.seconds));
        } else {
            say(still.status.problems());
        }
        frames_to_draw_ = frames_after_event;
    }
    const auto activity = compiler_.activity();
    const bool busy = activity == CompilerThread::Activity::compiling;
    const bool still = activity == CompilerThread::Activity::drawing_still;
    if (busy != compilation.busy || still != workspace_.drawing_still) {
        frames_to_draw_ = std::max(frames_to_draw_, 1);
    }
    compilation.busy = busy;
    workspace_.drawing_still = still;
}

/// News of measuring come many times a second, and showing them takes time from what is measured.
void EventLoop::look_at_accuracy() {
    const Accuracy::Phase before = workspace_.accuracy.phase;
    const double progress = workspace_.accuracy.progress;
    const auto answer = compiler_.take_trial();
    if (answer) accuracy_.take(*answer);
    const double now = glfwGetTime();
    accuracy_.look({.document = workspace_.shown(),
                    .camera = workspace_.camera(),
                    .width = workspace_.area.width,
                    .height = workspace_.area.height,
                    .watched = workspace_.view.accuracy,
                    .playing = workspace_.playback.playing},
                   now);
    const bool news = answer || progress != workspace_.accuracy.progress;
    const bool changed = before != workspace_.accuracy.phase;
    if (!changed && !(news && now - accuracy_shown_ > accuracy_news_seconds)) return;
    accuracy_shown_ = now;
    frames_to_draw_ = std::max(frames_to_draw_, 1);
}

/// Only while nothing else is going on: what is timed must have the machine for itself.
void EventLoop::start_trial() {
    if (frames_to_draw_ > 0 || !picture_.complete()) return;
    if (compiler_.activity() != CompilerThread::Activity::idle) return;
    if (auto trial = accuracy_.next_trial()) compiler_.request_trial(std::move(*trial));
}

void EventLoop::ask_compiler() {
    scene::Document document = workspace_.shown();
    if (asked_ && compiles_alike(*asked_, document)) return;
    compiler_.request(document);
    asked_ = std::move(document);
}

void EventLoop::ask_for_picture() {
    const Compilation& compilation = workspace_.compilation;
    if (!compilation.drawable) return;
    WantedPicture wanted{.document = workspace_.shown(),
                         .camera = workspace_.camera(),
                         .field_numbers = compilation.field_numbers,
                         .width = workspace_.area.width,
                         .height = workspace_.area.height};
    // The values hold for these bounds; newer ones must wait for the compiler.
    wanted.document.bounds = compilation.bounds;
    picture_.want(std::move(wanted));
}

void EventLoop::look_at_picture() {
    const auto news = picture_.take_news();
    if (news && !*news) return;
    const std::string problem = news ? "" : news.problems().front().message;
    if (!news && problem != picture_problem_) workspace_.error(problem);
    picture_problem_ = problem;
    frames_to_draw_ = std::max(frames_to_draw_, 1);
}

void EventLoop::draw_interface() {
    if (window_.framebuffer_width() == 0) return;
    const double now = glfwGetTime();
    if (workspace_.playback.playing) {
        workspace_.playback.time += std::min(now - last_frame_, 0.5);
    }
    last_frame_ = now;
    show_picture_and_panels();
    window_.swap();
    window_.set_title(workspace_.name() + (workspace_.unsaved() ? "* - Zeroset" : " - Zeroset"));
}

/// The picture stands still until it is on the screen's back buffer, but not for as long as
/// swapping may wait for the screen.
void EventLoop::show_picture_and_panels() {
    const PictureThread::Shown picture = picture_.show();
    workspace_.layers = picture.layers();
    workspace_.report = picture.report();
    workspace_.picture_complete = picture_.complete();
    workspace_.monospaced = gui_.monospaced();
    workspace_.scale = gui_.scale();
    workspace_.gesture = 0;

    gui_.begin();
    input_.feed();
    ImGui::NewFrame();
    handle_shortcuts(workspace_);
    show_interface(workspace_);
    ImGui::Render();
    record();
    ask_compiler();
    ask_for_picture();
    start_still();
    gui_.draw();
    window_.context().gl().Finish();
}

void EventLoop::record() {
    workspace_.history.record(workspace_.document, gesture(), glfwGetTime());
}

/// A press of a mouse button and everything until it is let go is one gesture; so is a burst of
/// typing in one field, and of turning the wheel.
Gesture EventLoop::gesture() {
    const ImGuiIO& io = ImGui::GetIO();
    const bool pressed = io.MouseDown[0] || io.MouseDown[1] || io.MouseDown[2];
    if (pressed && !was_pressed_) ++presses_;
    const bool released = was_pressed_ && !pressed;
    was_pressed_ = pressed;
    constexpr std::uint64_t press_kind = std::uint64_t{1} << 40;
    if (pressed || released) return {press_kind + presses_, true};
    if (io.WantTextInput) return {(press_kind << 1) + ImGui::GetActiveID(), false};
    return {workspace_.gesture, false};
}

void EventLoop::keep_safe() {
    // What an earlier loop has left must not be overwritten before the user has seen it.
    if (workspace_.dialogs.recovered) return;
    auto status = autosave_.update(workspace_.document, workspace_.unsaved(), glfwGetTime());
    if (!status) say(status.problems());
}

void EventLoop::start_still() {
    Dialogs& dialogs = workspace_.dialogs;
    if (!std::exchange(dialogs.still_wanted, false)) return;
    const std::filesystem::path file = dialogs.still_path;
    if (auto status = make_parent_folder(file); !status) return say(status.problems());
    const scene::Document document = workspace_.shown();
    const double aspect = static_cast<double>(dialogs.still_width) / dialogs.still_height;
    compiler_.request_still({.document = document,
                             .camera = scene::camera_of(document, aspect),
                             .width = dialogs.still_width,
                             .height = dialogs.still_height,
                             .file = file});
    workspace_.drawing_still = true;
}

void EventLoop::say(const base::Diagnostics& problems) {
    workspace_.report_problems(problems);
    frames_to_draw_ = frames_after_event;
}

}  // namespace studio
