// SPDX-License-Identifier: MIT
// How deep one can go into the fractals before the picture breaks, in the precision that is chosen.
// Measured by factors of sqrt(10), and of 10 beyond 1e5, printed, and recorded in
// precision_limits.json, which may only grow.
#include <cmath>
#include <filesystem>
#include <iostream>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "torture/scene.h"
#include "torture/tracing.h"
#include "torture/update.h"

namespace torture {
namespace {

using Json = nlohmann::ordered_json;

const std::filesystem::path limits_path =
    std::filesystem::path(ZEROSET_SOURCE_DIR) / "tests" / "torture" / "precision_limits.json";

constexpr int zoom_width = 40;
constexpr int zoom_height = 30;
/// A picture is broken if more than this part of its compared pixels is wrong.
constexpr double broken_share = 0.25;
constexpr double first_zoom = 1e2;
constexpr double last_fine_zoom = 1e5;
constexpr double last_zoom = 1e10;

struct Step {
    double zoom;
    double wrong_share;
};

/// The scene with its eye so far from the target.
Scene at_distance(Scene scene, double distance) {
    scene::Camera& camera = *scene.document.camera;
    const glm::dvec3 back = camera.eye - camera.target;
    camera.eye = camera.target + distance / 1e-2 * back;  // the scenes of 1e2 are 1e-2 away
    return scene;
}

double wrong_share(const Scene& scene) {
    const oracle::Reference reference = trace(scene, zoom_width, zoom_height);
    const auto metrics = oracle::compare(
        reference, render(scene, {"auto", "auto", std::nullopt}, zoom_width, zoom_height));
    EXPECT_TRUE(metrics) << scene.name;
    if (!metrics) return 1;
    // Where the last levels of the sponge are as small as pixels, half of them are beside an edge.
    EXPECT_GT(metrics->compared, zoom_width * zoom_height / 3u) << scene.name;
    return static_cast<double>(metrics->wrong()) / static_cast<double>(metrics->compared);
}

/// From the first zoom to the one that is broken.
std::vector<Step> measure(const std::string& fractal) {
    const Scene scene = read_scene("zooms/" + fractal + "_1e2");
    std::vector<Step> steps;
    if (!scene.document.camera) return steps;
    for (double zoom = first_zoom;; zoom *= zoom < 0.99 * last_fine_zoom ? std::sqrt(10) : 10) {
        if (zoom > 1.01 * last_zoom) return steps;
        steps.push_back({zoom, wrong_share(at_distance(scene, 1 / zoom))});
        if (steps.back().wrong_share > broken_share) return steps;
    }
}

/// The deepest zoom before the broken one; 0 if there is none.
double limit_of(const std::vector<Step>& steps) {
    double limit = 0;
    for (const Step& step : steps) {
        if (step.wrong_share <= broken_share) limit = step.zoom;
    }
    return limit;
}

Json json_of(const std::vector<Step>& steps) {
    const auto rounded = [](double value) { return Json::parse(fmt::format("{:.3g}", value)); };
    Json json{{"limit", rounded(limit_of(steps))}};
    for (const Step& step : steps) {
        json["steps"].push_back(
            {{"zoom", rounded(step.zoom)}, {"wrong_share", rounded(step.wrong_share)}});
    }
    return json;
}

Json read_limits() {
    const auto text = base::read_text(limits_path, 1 << 20);
    const Json json = text ? Json::parse(*text, nullptr, false) : Json::object();
    return json.is_object() ? json : Json::object();
}

class Precision : public testing::TestWithParam<std::string> {};

TEST_P(Precision, lasts_as_deep_as_recorded) {
    const std::vector<Step> steps = measure(GetParam());
    ASSERT_FALSE(steps.empty());
    for (const Step& step : steps) {
        std::cout << fmt::format("{} {:8.3g} times: {:5.1f} % wrong\n", GetParam(), step.zoom,
                                 100 * step.wrong_share);
    }
    Json limits = read_limits();
    const double recorded =
        limits.contains(GetParam()) ? limits[GetParam()].value("limit", 0.0) : 0;
    const double now = limit_of(steps);
    // One step less is left for other drivers.
    EXPECT_GT(now, 0.25 * recorded) << "UPDATE_TORTURE=raise records it";
    if (update() == Update::raise || (update() == Update::shrink && now > 1.01 * recorded)) {
        limits[GetParam()] = json_of(steps);
        ASSERT_TRUE(base::write_atomically(limits_path, limits.dump(2) + '\n'));
    } else if (update() == Update::none) {
        EXPECT_GT(recorded, 0) << "not recorded; UPDATE_TORTURE=1 records it";
    }
}

INSTANTIATE_TEST_SUITE_P(Fractals, Precision, testing::Values("julia", "mandelbulb", "menger"),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace torture
