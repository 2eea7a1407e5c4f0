// SPDX-License-Identifier: MIT
// The linked programs that draw one scene.
#pragma once

#include <optional>
#include <span>
#include <utility>

#include "base/result.h"
#include "render/gl.h"
#include "shader/program_source.h"

namespace render {

/// Owns a program object, and one for the pre-pass if there is one. The functions must outlive it,
/// and its context must be current (or one that shares with it) when it is destroyed.
class Program {
public:
    /// Compiles and links both; an error holds the driver's log with the lines it speaks of.
    static base::Result<Program> link(const Gl& gl, const shader::ProgramSource& source);

    Program(Program&& other) noexcept
        : gl_(other.gl_),
          name_(std::exchange(other.name_, 0)),
          prepass_name_(std::exchange(other.prepass_name_, 0)),
          doubled_(other.doubled_),
          background_(std::move(other.background_)) {}
    Program& operator=(Program&& other) noexcept;
    ~Program();

    GLuint name() const { return name_; }
    /// 0: there is no pre-pass.
    GLuint prepass_name() const { return prepass_name_; }
    /// Whether its uniform blocks are in double precision.
    bool doubled() const { return doubled_; }
    /// For the pixels around the bounds, not linked yet (BackgroundProgram).
    const std::optional<shader::BackgroundSource>& background() const { return background_; }

private:
    explicit Program(const Gl& gl) : gl_(&gl) {}

    const Gl* gl_;
    GLuint name_ = 0, prepass_name_ = 0;
    bool doubled_ = false;
    std::optional<shader::BackgroundSource> background_;
};

}  // namespace render
