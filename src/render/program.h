// SPDX-License-Identifier: MIT
// A linked program that draws one scene.
#pragma once

#include <span>
#include <utility>

#include "base/result.h"
#include "render/gl.h"
#include "shader/program_source.h"

namespace render {

/// Owns a program object. The functions must outlive it, and its context must be current (or one
/// that shares with it) when it is destroyed.
class Program {
public:
    /// Compiles and links; an error holds the driver's log with the lines it speaks of.
    static base::Result<Program> link(const Gl& gl, const shader::ProgramSource& source);

    Program(Program&& other) noexcept : gl_(other.gl_), name_(std::exchange(other.name_, 0)) {}
    Program& operator=(Program&& other) noexcept;
    ~Program();

    GLuint name() const { return name_; }

private:
    Program(const Gl& gl, GLuint name) : gl_(&gl), name_(name) {}

    const Gl* gl_;
    GLuint name_;
};

}  // namespace render
