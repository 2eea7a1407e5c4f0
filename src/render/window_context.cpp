// SPDX-License-Identifier: MIT
// A context that belongs to a window, whatever library made it.
#include "render/context.h"

namespace render {

namespace {

class WindowContext final : public Context {
public:
    WindowContext(const Gl& gl, void* window, void (*make_current)(void*))
        : window_(window), make_current_(make_current) {
        gl_ = gl;
    }

    void make_current() override { make_current_(window_); }
    void release() override { make_current_(nullptr); }

private:
    void* window_;
    void (*make_current_)(void*);
};

}  // namespace

base::Result<std::unique_ptr<Context>> wrap_window(void* window, Gl::Load load,
                                                   void (*make_current)(void* window)) {
    auto gl = Gl::load(load);
    if (!gl) return gl.problems();
    return std::unique_ptr<Context>(std::make_unique<WindowContext>(*gl, window, make_current));
}

}  // namespace render
