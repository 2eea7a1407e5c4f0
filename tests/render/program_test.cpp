// SPDX-License-Identifier: MIT
// Linking, its errors, and who owns the program object.
#include "render/program.h"

#include <utility>

#include "render/small_programs.h"

namespace {

using render::Program;
using render_test::text;

class ProgramTest : public render_test::WithContext {
protected:
    bool exists(GLuint name) const { return context->gl().IsProgram(name) == GL_TRUE; }
};

TEST_F(ProgramTest, links) {
    const auto program = Program::link(context->gl(), render_test::coordinates());
    ASSERT_TRUE(program) << text(program);
    EXPECT_TRUE(exists(program->name()));
}

TEST_F(ProgramTest, an_error_quotes_the_log_and_the_source_line) {
    shader::ProgramSource source = render_test::coordinates();
    source.fragment =
        "#version 450 core\nout vec4 colour;\nvoid main() {\n    colour = vec4(unheard_of);\n}\n";
    const auto program = Program::link(context->gl(), source);
    ASSERT_FALSE(program);
    const std::string message = text(program);
    // Mesa writes 0:4(19), NVIDIA 0(4).
    EXPECT_TRUE(message.starts_with("the OpenGL driver rejects the fragment shader:\n0:4(") ||
                message.starts_with("the OpenGL driver rejects the fragment shader:\n0(4)"))
        << message;
    EXPECT_LT(message.find("unheard_of"), message.find("\n     4 | ")) << message;
    EXPECT_NE(message.find("\n     4 |     colour = vec4(unheard_of);"), message.npos) << message;
}

TEST_F(ProgramTest, an_error_in_the_vertex_shader_says_so) {
    shader::ProgramSource source = render_test::coordinates();
    source.vertex = "#version 450 core\nvoid main() { gl_Position = 1; }\n";
    const auto program = Program::link(context->gl(), source);
    ASSERT_FALSE(program);
    const std::string message = text(program);
    EXPECT_TRUE(message.starts_with("the OpenGL driver rejects the vertex shader:\n0")) << message;
    EXPECT_NE(message.find("\n     2 | void main()"), message.npos) << message;
}

TEST_F(ProgramTest, stages_that_do_not_fit_are_an_error) {
    shader::ProgramSource source = render_test::coordinates();
    source.fragment =
        "#version 450 core\nin vec3 never_written;\nout vec4 colour;\n"
        "void main() { colour = vec4(never_written, 1); }\n";
    const auto program = Program::link(context->gl(), source);
    ASSERT_FALSE(program);
    EXPECT_TRUE(text(program).starts_with("the OpenGL driver cannot link the program:\n"))
        << text(program);
    EXPECT_NE(text(program).find("never_written"), std::string::npos) << text(program);
}

TEST_F(ProgramTest, is_deleted_with_its_owner) {
    GLuint name = 0;
    {
        const auto program = Program::link(context->gl(), render_test::coordinates());
        ASSERT_TRUE(program) << text(program);
        name = program->name();
        ASSERT_TRUE(exists(name));
    }
    EXPECT_FALSE(exists(name));
}

TEST_F(ProgramTest, moving_hands_the_object_on) {
    auto made = Program::link(context->gl(), render_test::coordinates());
    ASSERT_TRUE(made) << text(made);
    const GLuint name = made->name();
    {
        const Program moved = std::move(*made);
        EXPECT_EQ(moved.name(), name);
        EXPECT_EQ(made->name(), 0u);
        EXPECT_TRUE(exists(name));
    }
    EXPECT_FALSE(exists(name));
}

TEST_F(ProgramTest, assigning_gives_up_the_old_object) {
    auto first = Program::link(context->gl(), render_test::coordinates());
    auto second = Program::link(context->gl(), render_test::waves());
    ASSERT_TRUE(first && second);
    const GLuint old = first->name();
    const GLuint kept = second->name();
    {
        Program target = std::move(*first);
        target = std::move(*second);
        EXPECT_EQ(target.name(), kept);
        EXPECT_TRUE(exists(kept));
    }
    second = base::error("emptied");
    EXPECT_FALSE(exists(old));
    EXPECT_FALSE(exists(kept));
}

}  // namespace
