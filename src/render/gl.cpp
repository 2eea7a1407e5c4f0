// SPDX-License-Identifier: MIT
// Fills the table of OpenGL functions.
#include "render/gl.h"

#include <string>

#include <fmt/format.h>

namespace render {

namespace {

// Drivers hand out pointers for functions they only know by name, so the version counts as well.
base::Status check_version(const Gl& gl) {
    GLint major = 0;
    GLint minor = 0;
    gl.GetIntegerv(GL_MAJOR_VERSION, &major);
    gl.GetIntegerv(GL_MINOR_VERSION, &minor);
    if (major > 4 || (major == 4 && minor >= 5)) return base::Done{};
    return base::error(
        fmt::format("the driver offers OpenGL {}.{}, but 4.5 is needed; update the graphics driver",
                    major, minor));
}

}  // namespace

base::Result<Gl> Gl::load(Load load) {
    Gl gl;
    std::string missing;
    const auto find = [&](const char* name) {
        const Function function = load(name);
        if (!function) missing += fmt::format("{}{}", missing.empty() ? "" : ", ", name);
        return function;
    };
#define GL_FUNCTION(name, type) gl.name = reinterpret_cast<type>(find("gl" #name));
#include "render/gl_functions.def"
#undef GL_FUNCTION
    if (!missing.empty()) {
        return base::error(fmt::format(
            "the OpenGL driver lacks {}; OpenGL 4.5 is needed, update the graphics driver",
            missing));
    }
    if (auto version = check_version(gl); !version) return version.problems();
    return gl;
}

}  // namespace render
