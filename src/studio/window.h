// SPDX-License-Identifier: MIT
// The window, and hidden ones whose contexts share objects with it, for other threads.
#pragma once

#include <memory>
#include <string>

#include "base/result.h"
#include "render/context.h"

struct GLFWwindow;

namespace studio {

/// Owns GLFW and all windows. Used on the main thread only, apart from `wake` and the contexts of
/// the hidden windows.
class Window {
public:
    /// Opens all with OpenGL 4.5 core; the window's context is current on return, the others are
    /// not. An error names the cause and the way to make pictures without a display.
    static base::Result<std::unique_ptr<Window>> open(int width, int height);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    GLFWwindow* handle() { return main_; }
    render::Context& context() { return *context_; }
    render::Context& compiler_context() { return *compiler_context_; }
    render::Context& picture_context() { return *picture_context_; }

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
    GLFWwindow *compiler_ = nullptr, *picture_ = nullptr;
    std::unique_ptr<render::Context> context_, compiler_context_, picture_context_;
    std::string title_;
};

}  // namespace studio
