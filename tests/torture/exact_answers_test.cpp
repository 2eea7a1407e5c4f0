// SPDX-License-Identifier: MIT
// The oracle against scenes whose answer is known in closed form.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "torture/exact_answer.h"
#include "torture/scene.h"
#include "torture/tracing.h"

namespace torture {
namespace {

TEST(ExactAnswers, are_of_scenes_that_exist) {
    const auto names = scene_names();
    const std::set<std::string> known(names.begin(), names.end());
    for (const std::string& name : exact_scene_names()) EXPECT_TRUE(known.contains(name)) << name;
}

class ExactAnswer : public testing::TestWithParam<std::string> {};

/// What the oracle proves must be true of the exact answer; what it leaves open must hold it.
bool agrees(const oracle::Pixel& proven, const oracle::Pixel& exact) {
    const double margin = 1e-9 * (std::isfinite(exact.near) ? exact.near : 0);
    switch (proven.verdict) {
        case oracle::Verdict::miss:
            return exact.verdict == oracle::Verdict::miss;
        case oracle::Verdict::hit:
            return exact.verdict == oracle::Verdict::hit && exact.near >= proven.near - margin &&
                   exact.near <= proven.far + margin;
        case oracle::Verdict::undecided:
            return exact.verdict == oracle::Verdict::miss || exact.near >= proven.near - margin;
    }
    return false;
}

TEST_P(ExactAnswer, is_what_the_oracle_finds) {
    const Scene scene = read_scene(GetParam());
    const oracle::Reference exact =
        exact_reference(*exact_shape(GetParam()), scene.document, width, height);
    const oracle::Reference traced = trace(scene, width, height);
    ASSERT_EQ(traced.pixels.size(), exact.pixels.size());
    EXPECT_DOUBLE_EQ(traced.pixel_width, exact.pixel_width);
    EXPECT_FALSE(traced.heuristic);
    int undecided = 0;
    for (std::size_t i = 0; i < exact.pixels.size(); ++i) {
        const oracle::Pixel& pixel = traced.pixels[i];
        undecided += pixel.verdict == oracle::Verdict::undecided;
        if (exact.pixels[i].fragile) continue;
        EXPECT_TRUE(agrees(pixel, exact.pixels[i]))
            << "pixel " << i % width << ", " << i / width << ": verdict "
            << static_cast<int>(pixel.verdict)
            << fmt::format(" in [{}, {}], exactly {}", pixel.near, pixel.far, exact.pixels[i].near);
    }
    std::cout << fmt::format("{}: {} of {} pixels undecided\n", GetParam(), undecided,
                             exact.pixels.size());
}

INSTANTIATE_TEST_SUITE_P(Scenes, ExactAnswer, testing::ValuesIn(exact_scene_names()),
                         [](const auto& info) { return test_name(info.param); });

}  // namespace
}  // namespace torture
