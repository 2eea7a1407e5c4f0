// SPDX-License-Identifier: MIT
// Every preset's picture against the one that is kept here. `UPDATE_GOLDEN=1` rewrites those.
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/file.h"
#include "compile/compile.h"
#include "headless.h"
#include "image/compare.h"
#include "image/png.h"
#include "render/frame.h"
#include "render/still.h"
#include "scene/preset.h"

namespace {

namespace fs = std::filesystem;

const fs::path presets = fs::path(ZEROSET_SOURCE_DIR) / "presets";
const fs::path goldens = fs::path(ZEROSET_SOURCE_DIR) / "tests" / "golden";
const fs::path failures = fs::path(ZEROSET_BINARY_DIR) / "golden-failures";

constexpr int width = 160;
constexpr int height = 120;
/// A pixel has changed if a channel differs by more than this, of 255.
constexpr int tolerance = 16;
constexpr std::size_t most_changed = width * height / 200;
constexpr double most_mean = 1;

std::string text_of(const base::Diagnostics& problems) {
    std::string text;
    for (const base::Diagnostic& problem : problems) text += problem.message + '\n';
    return text;
}

/// The picture as the command line draws it: without the ground grid.
base::Result<image::Picture> draw(const fs::path& path) {
    const auto text = base::read_text(path, scene::largest_preset);
    if (!text) return text.problems();
    auto preset = scene::read_preset(*text);
    if (!preset) return preset.problems();
    scene::Document document = std::move(preset->document);
    document.settings.grid = false;
    const auto formula = compile::compile_formula(document.formula);
    if (!formula) return formula.problems();
    auto context = open_headless();
    if (!context) return context.problems();
    const shader::Outputs outputs;
    const shader::ProgramSource source = compile::program_source(*formula, document, outputs);
    const scene::Camera camera = scene::camera_of(document, static_cast<double>(width) / height);
    auto still = render::draw_still(
        **context, source, compile::field_numbers(*formula, source, document),
        [&](const render::View& view) { return render::frame(document, camera, view); },
        render::whole(width, height), outputs);
    if (!still) return still.problems();
    return std::move(still->picture);
}

bool is_updating() {
    const char* value = std::getenv("UPDATE_GOLDEN");
    return value != nullptr && std::string(value) == "1";
}

/// Leaves expected, actual and difference for people to look at, and says where.
std::string keep_failure(const std::string& name, const image::Picture& expected,
                         const image::Picture& actual, const image::Picture& difference) {
    const fs::path base = failures / name;
    fs::create_directories(base.parent_path());
    std::string names;
    const auto keep = [&](const char* what, const image::Picture& picture) {
        const fs::path path = base.string() + "-" + what + ".png";
        if (image::write_png(path, picture)) names += "\n  " + path.string();
    };
    keep("expected", expected);
    keep("actual", actual);
    keep("difference", difference);
    return names;
}

std::vector<std::string> preset_names() {
    std::vector<std::string> names;
    for (fs::path path : scene::list_presets(presets)) {
        names.push_back(path.replace_extension().generic_string());
    }
    return names;
}

class Golden : public testing::TestWithParam<std::string> {};

TEST_P(Golden, is_what_the_preset_shows) {
    const std::string& name = GetParam();
    const auto actual = draw(presets / (name + ".json"));
    ASSERT_TRUE(actual) << text_of(actual.problems());
    const fs::path path = goldens / (name + ".png");
    if (is_updating()) {
        fs::create_directories(path.parent_path());
        const auto written = image::write_png(path, *actual);
        ASSERT_TRUE(written) << text_of(written.problems());
        return;
    }
    ASSERT_TRUE(fs::exists(path)) << "the preset has no golden; make one with UPDATE_GOLDEN=1";
    const auto expected = image::read_png(path);
    ASSERT_TRUE(expected) << text_of(expected.problems());
    ASSERT_EQ(expected->width, actual->width);
    ASSERT_EQ(expected->height, actual->height);
    const image::Difference difference = image::compare(*expected, *actual, tolerance);
    if (difference.changed <= most_changed && difference.mean < most_mean) return;
    ADD_FAILURE() << fmt::format(
        "{} of {} pixels differ by more than {} (at most {} may), the mean difference is {:.3f}, "
        "the "
        "largest {}; see{}",
        difference.changed, width * height, tolerance, most_changed, difference.mean,
        difference.largest, keep_failure(name, *expected, *actual, difference.picture));
}

std::string name_of(const testing::TestParamInfo<std::string>& info) {
    std::string name;
    for (const char c : info.param) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(Presets, Golden, testing::ValuesIn(preset_names()), name_of);

TEST(Goldens, all_have_a_preset) {
    const auto names = preset_names();
    const std::set<std::string> known(names.begin(), names.end());
    for (const auto& entry : fs::recursive_directory_iterator(goldens)) {
        if (entry.path().extension() != ".png") continue;
        fs::path name = fs::relative(entry.path(), goldens);
        name.replace_extension();
        EXPECT_TRUE(known.contains(name.generic_string()))
            << name << " has no preset; delete the picture";
    }
}

}  // namespace
