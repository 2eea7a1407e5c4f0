// SPDX-License-Identifier: MIT
#include "studio/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

namespace studio {
namespace {

base::Diagnostic no_window(const char* what) {
    const char* cause = nullptr;
    glfwGetError(&cause);
    return base::error(
        fmt::format("cannot open {}: {}; use 'zeroset render' to make pictures without a display",
                    what, cause ? cause : "the window system gives no reason"));
}

render::Gl::Function load(const char* name) { return glfwGetProcAddress(name); }

void make_current(void* window) { glfwMakeContextCurrent(static_cast<GLFWwindow*>(window)); }

base::Result<std::unique_ptr<render::Context>> wrap(GLFWwindow* window) {
    glfwMakeContextCurrent(window);
    auto context = render::wrap_window(window, load, make_current);
    if (context) return context;
    base::Diagnostics problems = context.problems();
    problems.push_back(
        base::error("the studio cannot draw in a window here; use 'zeroset render' instead"));
    return problems;
}

}  // namespace

base::Result<std::unique_ptr<Window>> Window::open(int width, int height) {
    if (!glfwInit()) return no_window("a window");
    std::unique_ptr<Window> window(new Window);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "zeroset");
    glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "zeroset");
    window->main_ = glfwCreateWindow(width, height, "Zeroset", nullptr, nullptr);
    if (!window->main_) return no_window("a window with OpenGL 4.5");
    glfwSetWindowSizeLimits(window->main_, 640, 400, GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    window->compiler_ = glfwCreateWindow(16, 16, "Zeroset compiler", nullptr, window->main_);
    window->picture_ = glfwCreateWindow(16, 16, "Zeroset picture", nullptr, window->main_);
    if (!window->compiler_ || !window->picture_)
        return no_window("a second OpenGL context that shares with the first");

    auto compiler_context = wrap(window->compiler_);
    if (!compiler_context) return compiler_context.problems();
    window->compiler_context_ = std::move(*compiler_context);
    auto picture_context = wrap(window->picture_);
    if (!picture_context) return picture_context.problems();
    window->picture_context_ = std::move(*picture_context);
    auto context = wrap(window->main_);
    if (!context) return context.problems();
    window->context_ = std::move(*context);
    glfwSwapInterval(1);
    return window;
}

Window::~Window() {
    glfwMakeContextCurrent(nullptr);
    for (GLFWwindow* hidden : {compiler_, picture_})
        if (hidden) glfwDestroyWindow(hidden);
    if (main_) glfwDestroyWindow(main_);
    glfwTerminate();
}

void Window::set_title(const std::string& title) {
    if (title == title_) return;
    title_ = title;
    glfwSetWindowTitle(main_, title.c_str());
}

int Window::framebuffer_width() const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(main_, &width, &height);
    return width;
}

int Window::framebuffer_height() const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(main_, &width, &height);
    return height;
}

float Window::content_scale() const {
    float x = 1, y = 1;
    glfwGetWindowContentScale(main_, &x, &y);
    return x > 0 ? x : 1;
}

float Window::pixel_ratio() const {
    int width = 0, height = 0;
    glfwGetWindowSize(main_, &width, &height);
    return width > 0 && framebuffer_width() > 0
               ? static_cast<float>(framebuffer_width()) / static_cast<float>(width)
               : 1;
}

void Window::handle_events(double seconds) {
    if (seconds > 0) {
        glfwWaitEventsTimeout(seconds);
    } else {
        glfwPollEvents();
    }
}

void Window::wake() { glfwPostEmptyEvent(); }

bool Window::wants_to_close() const { return glfwWindowShouldClose(main_); }

void Window::stay_open() { glfwSetWindowShouldClose(main_, GLFW_FALSE); }

void Window::swap() { glfwSwapBuffers(main_); }

}  // namespace studio
