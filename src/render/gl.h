// SPDX-License-Identifier: MIT
// The OpenGL functions of one driver, as a table. Nothing links OpenGL: several drivers may be
// loaded in one process, and each context brings its own table.
#pragma once

#include <GL/glcorearb.h>

#include "base/result.h"

namespace render {

/// Members are named as the functions are, without "gl": `gl.DrawArrays(...)`.
struct Gl {
    using Function = void (*)();
    /// How glfwGetProcAddress, OSMesaGetProcAddress and eglGetProcAddress look.
    using Load = Function (*)(const char* name);

#define GL_FUNCTION(name, type) type name = nullptr;
#include "render/gl_functions.def"
#undef GL_FUNCTION

    /// Loads all functions of the context that is current on this thread. Functions that the driver
    /// lacks, or a version below 4.5, are an error that names them.
    static base::Result<Gl> load(Load load);
};

}  // namespace render
