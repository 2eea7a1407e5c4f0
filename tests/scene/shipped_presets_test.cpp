// SPDX-License-Identifier: MIT
// The presets that come with the program: read without a complaint and written as they are.
#include <gtest/gtest.h>

#include "base/file.h"
#include "scene/preset.h"

namespace {

const std::filesystem::path folder = std::filesystem::path(ZEROSET_SOURCE_DIR) / "presets";

TEST(ShippedPresets, are_at_least_two_dozen) { EXPECT_GE(scene::list_presets(folder).size(), 24u); }

TEST(ShippedPresets, are_read_without_a_complaint) {
    for (const auto& name : scene::list_presets(folder)) {
        const auto text = base::read_text(folder / name, scene::largest_preset);
        ASSERT_TRUE(text) << name;
        const auto preset = scene::read_preset(*text);
        ASSERT_TRUE(preset) << base::format(preset.problems()[0], name.string(), *text);
        EXPECT_TRUE(preset->warnings.empty()) << name;
        EXPECT_FALSE(preset->document.title.empty()) << name;
        EXPECT_TRUE(preset->document.description.ends_with('.')) << name;
        EXPECT_TRUE(preset->document.camera) << name;
    }
}

TEST(ShippedPresets, are_spelt_as_they_would_be_saved) {
    for (const auto& name : scene::list_presets(folder)) {
        const auto text = base::read_text(folder / name, scene::largest_preset);
        const auto preset = scene::read_preset(*text);
        ASSERT_TRUE(preset) << name;
        EXPECT_EQ(scene::write_preset(preset->document), *text) << name;
    }
}

TEST(ShippedPresets, have_different_names_and_titles) {
    std::map<std::string, int> names;
    std::map<std::string, int> titles;
    for (const auto& name : scene::list_presets(folder)) {
        EXPECT_EQ(++names[name.stem().string()], 1) << name;
        const auto text = base::read_text(folder / name, scene::largest_preset);
        EXPECT_EQ(++titles[scene::read_preset(*text)->document.title], 1) << name;
    }
    EXPECT_EQ(names["default"], 1) << "it is opened first";
}

}  // namespace
