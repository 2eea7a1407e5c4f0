// SPDX-License-Identifier: MIT
// The window, and a second, hidden one whose context shares objects with it for the compiler's
// thread.
#pragma once

#include <memory>
#include <string>

#include "base/result.h"
#include "render/context.h"

struct GLFWwindow;

namespace studio {

/// Owns GLFW and both windows. Used on the main thread only, apart from `wake` and the worker's
/// context.
class Window {
public:
    /// Opens both with OpenGL 4.5 core; the window's context is current on return, the worker's is
    /// not. An error names the cause and the way to make pictures without a display.
    static base::Result<std::unique_ptr<Window>> open(int width, int height);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    GLFWwindow* handle() { return main_; }
    render::Context& context() { return *context_; }
    render::Context& worker_context() { return *worker_context_; }

    void set_title(const std::string& title);
    /// In pixels; 0 while the window is minimised.
    int framebuffer_width() const;
    int framebuffer_height() const;
    /// Pixels of the screen per unit of the desktop: 2 on a hi-DPI screen.
    float content_scale() const;
    /// Pixels per unit of mouse positions: 1 on X11, the content scale elsewhere.
    float pixel_ratio() const;

    /// Handles what has come in. Waits for it at most so long; 0 does not wait.
    void handle_events(double seconds);
    /// Ends a wait; from any thread.
    static void wake();

    bool wants_to_close() const;
    /// Takes the wish to close back.
    void stay_open();
    void swap();

private:
    Window() = default;

    GLFWwindow* main_ = nullptr;
    GLFWwindow* worker_ = nullptr;
    std::unique_ptr<render::Context> context_, worker_context_;
    std::string title_;
};

}  // namespace studio
