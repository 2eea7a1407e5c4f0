// SPDX-License-Identifier: MIT
// Fragment shaders whose pixels are known, and the context that they run in.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "headless.h"
#include "render/context.h"
#include "render/frame.h"
#include "shader/program_source.h"

namespace render_test {

/// All problems in one text.
template <class T>
std::string text(const base::Result<T>& result) {
    std::string joined;
    for (const base::Diagnostic& problem : result.problems()) joined += problem.message + "\n";
    return joined;
}

inline const std::string preamble = R"(#version 450 core
layout(std140, binding = 0) uniform Frame {
    vec4 eye; vec4 right; vec4 up; vec4 forward; vec4 picture; vec4 bounds_centre; vec4 bounds_half;
    vec4 march; vec4 sky; vec4 ground; vec4 background_top; vec4 background_bottom;
    vec4 passes; vec4 origin;
    vec4 light_direction[8]; vec4 light_colour[8]; vec4 material[16]; vec4 material_shininess[16];
};
layout(std140, binding = 1) uniform FieldValues { vec4 field_values[2]; };
layout(location = 0) out vec4 out_picture;
layout(location = 1) out vec4 out_geometry;
layout(location = 2) out vec4 out_normal;
)";

/// A program with this body of main(), where `pixel` is the pixel of the full picture, counted from
/// the left and the top.
inline shader::ProgramSource program(const std::string& body) {
    shader::ProgramSource source;
    source.vertex = R"(#version 450 core
void main() {
    gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}
)";
    source.fragment = preamble +
                      "void main() {\n    vec2 pixel = gl_FragCoord.xy - 0.5 + picture.zw;\n"
                      "    out_picture = vec4(0); out_geometry = vec4(0); out_normal = vec4(0);\n" +
                      body + "\n}\n";
    return source;
}

/// Red counts columns, green counts rows, modulo 256, in the picture; both exactly in geometry.
inline shader::ProgramSource coordinates() {
    return program(
        "    out_picture = vec4(mod(pixel, 256.0) / 255.0, 0.0, 1.0);\n"
        "    out_geometry = vec4(pixel, 0.0, 0.0);");
}

/// Numbers in which any change of rounding between two ways of drawing would show.
inline shader::ProgramSource waves() {
    return program(
        "    vec2 p = (pixel + 0.5) / picture.xy;\n"
        "    float f = 0.0;\n"
        "    for (int i = 1; i < 9; ++i) f += sin(float(i) * 37.0 * p.x + f) * cos(53.0 * p.y);\n"
        "    out_picture = vec4(fract(f), p, 1.0);\n"
        "    out_geometry = vec4(f, exp(f), 1.0 / f, sqrt(abs(f)));\n"
        "    out_normal = vec4(normalize(vec3(p, f)), f);");
}

/// A frame that holds nothing but the view.
inline render::Frame frame_of(const render::View& view) {
    render::Frame frame{};
    frame.picture = glm::vec4(view.width, view.height, view.x, view.y);
    return frame;
}

inline constexpr shader::Outputs picture_only{true, false, false, false};
inline constexpr shader::Outputs everything{true, true, true, false};

/// Gives each test its own OSMesa context.
class WithContext : public testing::Test {
protected:
    void SetUp() override {
        auto opened = open_headless();
        ASSERT_TRUE(opened) << text(opened);
        context = std::move(*opened);
    }

    std::unique_ptr<render::Context> context;
};

}  // namespace render_test
