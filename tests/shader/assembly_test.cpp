// SPDX-License-Identifier: MIT
// Parts of shaders/ joined into one text.
#include "shader/assembly.h"

#include <gtest/gtest.h>

#include "shader/parts.h"
#include "shader/programs.h"

namespace shader {
namespace {

TEST(Assembly, puts_a_part_after_what_it_includes_and_each_once) {
    Assembly assembly;
    assembly.add_part("operator/tan.glsl");
    assembly.add_part("operator/sin.glsl");
    assembly.add_part("operator/tan.glsl");
    const std::string& text = assembly.text();
    const std::size_t turn = text.find("real2 zs_sincos("), tangent = text.find("real zs_tan(");
    ASSERT_NE(turn, std::string::npos);
    ASSERT_NE(tangent, std::string::npos);
    EXPECT_LT(turn, tangent);
    EXPECT_EQ(text.find("real2 zs_sincos(", turn + 1), std::string::npos);
    EXPECT_EQ(text.find("real zs_tan(", tangent + 1), std::string::npos);
}

TEST(Assembly, leaves_out_comments_includes_and_blank_lines_of_every_part) {
    for (const auto& [path, content] : parts()) {
        Assembly assembly;
        assembly.add_part(path);
        EXPECT_FALSE(has(assembly.text(), "//")) << path;
        EXPECT_FALSE(has(assembly.text(), "/*")) << path << ": only // is left out";
        EXPECT_FALSE(has(assembly.text(), "#include")) << path;
        EXPECT_FALSE(has(assembly.text(), "\n\n")) << path;
        EXPECT_TRUE(assembly.text().ends_with('\n')) << path;
    }
}

TEST(Assembly, keeps_code_as_it_is) {
    Assembly assembly;
    assembly.add_code("int a;\n");
    assembly.add_part("operator/exp.glsl");
    assembly.add_code("int b;\n");
    EXPECT_EQ(assembly.text(), "int a;\nreal zs_exp(real x) { return exp(x); }\nint b;\n");
}

/// Every file that the table of operators names exists.
TEST(Assembly, has_a_part_for_every_operator) {
    graph::for_each_operator([](graph::Op op) {
        const std::string file(graph::facts(op).glsl_file);
        if (file.empty()) return;
        const auto part = parts().find("operator/" + file + ".glsl");
        ASSERT_NE(part, parts().end()) << file;
        EXPECT_TRUE(has(part->second, "real " + std::string(graph::facts(op).glsl) + "("))
            << file << " does not define " << graph::facts(op).glsl;
    });
}

}  // namespace
}  // namespace shader
