// SPDX-License-Identifier: MIT
// Fields as text.
#include "field/print_field.h"

#include "field/shapes.h"

namespace field {
namespace {

TEST(PrintField, shows_the_tree_with_the_expressions_of_its_leaves) {
    Field f;
    const FieldId sheet =
        f.add(Formula{.value = f.graph.variable(graph::variable_z), .kind = Kind::sheet});
    const FieldId sphere = add_primitive(f, "sphere", {2});
    f.root = f.add(Intersection{sheet, f.add(Complement{sphere})});
    EXPECT_EQ(print(f),
              "intersection\n"
              "  sheet\n"
              "    n0 = z\n"
              "    value: n0\n"
              "  complement\n"
              "    solid distance\n"
              "      n0 = z\n"
              "      n1 = 2\n"
              "      n2 = x\n"
              "      n3 = y\n"
              "      n4 = hypot3 n2 n3 n0\n"
              "      n5 = sub n4 n1\n"
              "      value: n5\n");
}

TEST(PrintField, names_the_parts_of_an_iteration) {
    Field f;
    f.root = shells(f, 3);
    const std::string text = print(f);
    for (const char* part : {"iteration\n", "start distance: ", "step distance: ", "start scale: ",
                             "step scale: ", "limit: ", "distance: "}) {
        EXPECT_NE(text.find(part), std::string::npos) << part;
    }
    EXPECT_EQ(text.find("escape"), std::string::npos);
}

}  // namespace
}  // namespace field
