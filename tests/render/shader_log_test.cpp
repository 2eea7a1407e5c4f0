// SPDX-License-Identifier: MIT
// Driver logs in the forms of three vendors.
#include "render/shader_log.h"

#include <gtest/gtest.h>

namespace {

constexpr const char* source = "first\nsecond line\nthird";

TEST(ShaderLog, quotes_the_line_of_a_mesa_message) {
    EXPECT_EQ(render::annotate("0:2(7): error: `q' undeclared\n", source),
              "0:2(7): error: `q' undeclared\n     2 | second line");
}

TEST(ShaderLog, quotes_the_line_of_an_nvidia_message) {
    EXPECT_EQ(render::annotate("0(3) : error C1503: undefined variable", source),
              "0(3) : error C1503: undefined variable\n     3 | third");
}

TEST(ShaderLog, quotes_the_line_of_an_amd_message) {
    EXPECT_EQ(render::annotate("ERROR: 0:1: 'q' : undeclared identifier", source),
              "ERROR: 0:1: 'q' : undeclared identifier\n     1 | first");
}

TEST(ShaderLog, keeps_lines_that_name_no_place) {
    EXPECT_EQ(render::annotate("error: too many uniforms\n\n1 error\n", source),
              "error: too many uniforms\n1 error");
}

TEST(ShaderLog, quotes_nothing_for_a_line_that_does_not_exist) {
    EXPECT_EQ(render::annotate("0:4(1): error: end of file", source), "0:4(1): error: end of file");
    EXPECT_EQ(render::annotate("0:0(1): error: nowhere", source), "0:0(1): error: nowhere");
}

TEST(ShaderLog, drops_the_terminating_zero_that_drivers_count) {
    EXPECT_EQ(render::annotate(std::string_view("broken\n\0", 8), source), "broken");
}

TEST(ShaderLog, cuts_long_logs) {
    EXPECT_EQ(render::annotate("a\nb\nc\nd", source, 2), "a\nb\n...");
    EXPECT_EQ(render::annotate("a\nb\n", source, 2), "a\nb");
}

}  // namespace
