// SPDX-License-Identifier: MIT
// Compiling and linking.
#include "render/program.h"

#include <string>

#include <fmt/format.h>

#include "render/shader_log.h"

namespace render {

namespace {

/// A shader object for as long as its program is being linked.
class Shader {
public:
    Shader(const Gl& gl, GLenum stage) : gl_(&gl), name_(gl.CreateShader(stage)) {}
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;
    ~Shader() { gl_->DeleteShader(name_); }

    GLuint name() const { return name_; }

private:
    const Gl* gl_;
    GLuint name_;
};

std::string shader_log(const Gl& gl, GLuint shader) {
    GLint length = 0;
    gl.GetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    if (length > 0) gl.GetShaderInfoLog(shader, length, nullptr, log.data());
    return log;
}

std::string program_log(const Gl& gl, GLuint program) {
    GLint length = 0;
    gl.GetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    if (length > 0) gl.GetProgramInfoLog(program, length, nullptr, log.data());
    return log;
}

base::Status compile(const Gl& gl, const Shader& shader, std::string_view stage,
                     const std::string& source) {
    const char* text = source.data();
    const auto length = static_cast<GLint>(source.size());
    gl.ShaderSource(shader.name(), 1, &text, &length);
    gl.CompileShader(shader.name());
    GLint compiled = GL_FALSE;
    gl.GetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled) return base::Done{};
    return base::error(fmt::format("the OpenGL driver rejects the {} shader:\n{}", stage,
                                   annotate(shader_log(gl, shader.name()), source)));
}

/// Links into a program object that exists; `stage` names the fragment shader in errors.
base::Status link(const Gl& gl, GLuint program, const Shader& vertex, std::string_view stage,
                  const std::string& source) {
    const Shader fragment(gl, GL_FRAGMENT_SHADER);
    if (auto done = compile(gl, fragment, stage, source); !done) return done.problems();
    for (const Shader* shader : {&vertex, &fragment}) gl.AttachShader(program, shader->name());
    gl.LinkProgram(program);
    for (const Shader* shader : {&vertex, &fragment}) gl.DetachShader(program, shader->name());
    GLint linked = GL_FALSE;
    gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked) return base::Done{};
    return base::error(fmt::format("the OpenGL driver cannot link the program:\n{}",
                                   annotate(program_log(gl, program), source)));
}

}  // namespace

base::Result<Program> Program::link(const Gl& gl, const shader::ProgramSource& source) {
    const Shader vertex(gl, GL_VERTEX_SHADER);
    if (auto done = compile(gl, vertex, "vertex", source.vertex); !done) return done.problems();
    Program program(gl);
    program.name_ = gl.CreateProgram();
    auto done = render::link(gl, program.name_, vertex, "fragment", source.fragment);
    if (done && !source.prepass.empty()) {
        program.prepass_name_ = gl.CreateProgram();
        done = render::link(gl, program.prepass_name_, vertex, "pre-pass", source.prepass);
    }
    if (!done) return done.problems();
    program.doubled_ = source.precision == shader::Precision::doubled;
    program.background_ = source.background;
    return program;
}

Program& Program::operator=(Program&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(name_, other.name_);
    std::swap(prepass_name_, other.prepass_name_);
    std::swap(doubled_, other.doubled_);
    std::swap(background_, other.background_);
    return *this;
}

Program::~Program() {
    for (const GLuint name : {name_, prepass_name_})
        if (name != 0) gl_->DeleteProgram(name);
}

}  // namespace render
