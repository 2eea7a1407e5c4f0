// SPDX-License-Identifier: MIT
#include "torture/scene.h"

#include <cctype>

#include <gtest/gtest.h>

#include "base/file.h"
#include "scene/preset.h"

namespace torture {
namespace {

const std::filesystem::path folder =
    std::filesystem::path(ZEROSET_SOURCE_DIR) / "tests" / "torture" / "scenes";

}  // namespace

std::vector<std::string> scene_names() {
    std::vector<std::string> names;
    for (std::filesystem::path path : scene::list_presets(folder)) {
        names.push_back(path.replace_extension().generic_string());
    }
    return names;
}

Scene read_scene(const std::string& name) {
    const auto text = base::read_text(folder / (name + ".json"), scene::largest_preset);
    if (!text) {
        ADD_FAILURE() << text_of(text.problems());
        return {};
    }
    auto preset = scene::read_preset(*text);
    if (!preset) {
        ADD_FAILURE() << name << ": " << text_of(preset.problems());
        return {};
    }
    EXPECT_TRUE(preset->warnings.empty()) << name << ": " << text_of(preset->warnings);
    auto formula = compile::compile_formula(preset->document.formula);
    if (!formula) {
        ADD_FAILURE() << name << ": " << text_of(formula.problems());
        return {};
    }
    return {name, std::move(preset->document), std::move(*formula)};
}

std::string test_name(const std::string& scene_name) {
    std::string name;
    for (const char c : scene_name) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
}

std::string text_of(const base::Diagnostics& problems) {
    std::string text;
    for (const base::Diagnostic& problem : problems) text += problem.message + '\n';
    return text;
}

}  // namespace torture
