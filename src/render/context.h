// SPDX-License-Identifier: MIT
// An OpenGL 4.5 core context, wherever it comes from.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "base/result.h"
#include "render/gl.h"

namespace render {

/// A context and its functions. Using `gl()` needs the context to be current on this thread.
class Context {
public:
    virtual ~Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    virtual void make_current() = 0;
    /// Leaves the thread without a current context.
    virtual void release() = 0;

    const Gl& gl() const { return gl_; }
    /// The driver's own string (GL_RENDERER).
    std::string renderer() const;
    /// Versions of OpenGL and of the driver (GL_VERSION).
    std::string version() const;
    /// GL_MAX_TEXTURE_SIZE.
    int largest_size() const;

protected:
    Context() = default;
    Gl gl_;
};

/// Off-screen, software, through libOSMesa, which is opened at run time. Current on return.
base::Result<std::unique_ptr<Context>> open_osmesa();

/// Off-screen through EGL without a surface: a real GPU where there is one. Current on return.
base::Result<std::unique_ptr<Context>> open_egl();

/// One of the two above by its name, "osmesa" or "egl".
base::Result<std::unique_ptr<Context>> open_headless(std::string_view backend);

/// Wraps a window's context, which must be current; `load` is the window library's
/// getProcAddress, `make_current(window)` and `make_current(nullptr)` change the thread's context.
base::Result<std::unique_ptr<Context>> wrap_window(void* window, Gl::Load load,
                                                   void (*make_current)(void* window));

}  // namespace render
