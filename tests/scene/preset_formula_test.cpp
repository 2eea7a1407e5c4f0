// SPDX-License-Identifier: MIT
// Places in a preset's formula are places in its file.
#include <gtest/gtest.h>

#include "scene/preset.h"

namespace {

TEST(FormulaPlaces, lead_from_the_formula_to_the_file) {
    const std::string text = R"({"zeroset": 1, "formula": ["a = \"q\" + 1", "", "\u0078 = a"]})";
    const auto preset = scene::read_preset(text);
    ASSERT_TRUE(preset);
    const std::string& formula = preset->document.formula;
    const std::vector<std::uint32_t>& places = preset->formula_places;
    ASSERT_EQ(formula, "a = \"q\" + 1\n\nx = a");
    ASSERT_EQ(places.size(), formula.size() + 1);
    EXPECT_EQ(places[0], text.find("a = "));
    EXPECT_EQ(places[4], text.find("\\\"q"));
    EXPECT_EQ(places[5], text.find("q"));
    const std::size_t first_end = text.find("1\", \"\"") + 1;
    EXPECT_EQ(places[11], first_end) << "the line break is the end of its line";
    EXPECT_EQ(places[12], first_end + 4) << "the empty line";
    EXPECT_EQ(places[13], text.find("\\u0078"));
    EXPECT_EQ(places[14], text.find(" = a\"]"));
    EXPECT_EQ(places[18], text.find("\"]}")) << "the end of the formula";
}

TEST(FormulaPlaces, of_a_single_text_end_at_its_closing_quote) {
    const std::string text = R"({"formula": "x = 1", "zeroset": 1})";
    const auto preset = scene::read_preset(text);
    ASSERT_TRUE(preset);
    EXPECT_EQ(preset->formula_places, (std::vector<std::uint32_t>{13, 14, 15, 16, 17, 18}));
}

TEST(FormulaPlaces, grow_with_the_formula) {
    for (const char* text :
         {R"({"zeroset": 1, "formula": "x\ny"})", R"({"zeroset": 1, "formula": ["x", "y"]})",
          R"({"zeroset": 1, "formula": ["x\ny", ""]})"}) {
        const auto preset = scene::read_preset(text);
        ASSERT_TRUE(preset) << text;
        const auto& places = preset->formula_places;
        EXPECT_EQ(places.size(), preset->document.formula.size() + 1) << text;
        EXPECT_TRUE(std::is_sorted(places.begin(), places.end())) << text;
    }
}

}  // namespace
