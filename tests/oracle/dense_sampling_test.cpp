// SPDX-License-Identifier: MIT
// Certificates against brute force: many points of each ray in long double, by another evaluator.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <optional>
#include <string>

#include "analysis/random_scene.h"
#include "base/file.h"
#include "compile/parameter_values.h"
#include "field/print_field.h"
#include "oracle/ray.h"
#include "oracle/traced.h"
#include "oracle/wide_field.h"
#include "render_answers/exact_shape.h"
#include "scene/preset.h"

namespace oracle {
namespace {

/// The points of a ray, and what is between them.
class Samples {
public:
    Samples(const field::Field& field, const std::vector<double>& parameters,
            const render_answers::Ray& ray)
        : wide_(field, parameters), ray_(ray) {}

    WideField::Content at(long double t) {
        WideField::Point point;
        for (int i = 0; i < 3; ++i) {
            point[static_cast<std::size_t>(i)] =
                Extended::of(ray_.origin[i] + t * static_cast<long double>(ray_.direction[i]));
        }
        return wide_.at(point);
    }

    /// Whether something of the shape is between two places for sure: the later one is inside of a
    /// solid, or a sheet was crossed, with its value falling to 0 and no pole or jump there.
    bool surface_between(long double a, const WideField::Content& at_a, long double b,
                         const WideField::Content& at_b) {
        if (at_b.solid.number <= 0) return true;
        for (std::size_t i = 0; i < at_a.sheets.size(); ++i) {
            if (crosses(i, a, at_a.sheets[i], b, at_b.sheets[i])) return true;
        }
        return false;
    }

private:
    static bool differ(const WideField::Sheet& a, const WideField::Sheet& b) {
        return (a.value.number > 0 && b.value.number < 0) ||
               (a.value.number < 0 && b.value.number > 0);
    }
    bool crosses(std::size_t number, long double a, WideField::Sheet at_a, long double b,
                 WideField::Sheet at_b) {
        if (!differ(at_a, at_b)) return false;
        const long double size = std::min(std::abs(at_a.value.number), std::abs(at_b.value.number));
        for (int i = 0; i < 60; ++i) {
            const long double middle = 0.5L * (a + b);
            const WideField::Sheet at = this->at(middle).sheets[number];
            if (differ(at_a, at)) {
                b = middle;
                at_b = at;
            } else if (differ(at, at_b)) {
                a = middle;
                at_a = at;
            } else {
                return at.value.number == 0 && at.kept;  // on it, or undefined
            }
        }
        const long double least =
            std::max(std::abs(at_a.value.number), std::abs(at_b.value.number));
        return at_a.kept && at_b.kept && least < 1e-3L * size;
    }

    WideField wide_;
    render_answers::Ray ray_;
};

struct Tally {
    int hits = 0, misses = 0, undecided = 0;
};

/// Holds every pixel of the reference against samples of its ray.
Tally check(const compile::Formula& formula, const scene::Document& document, int width, int height,
            int samples, const std::string& what) {
    const Query query{.width = width, .height = height, .region = {}, .threads = 1, .progress = {}};
    const auto reference = trace(formula, document, query);
    Tally tally;
    EXPECT_TRUE(reference);
    if (!reference) return tally;
    EXPECT_FALSE(reference->heuristic) << what;
    const std::vector<double> parameters = compile::parameter_values(formula.field, document);
    const scene::Camera camera = scene::camera_of(document, static_cast<double>(width) / height);
    const render_answers::Solid region = render_answers::inside(document.bounds);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            // The very ray, for where f is steep its rounding moves the root.
            const Ray same = Pinhole(camera, width, height).through(x + 0.5, y + 0.5);
            const render_answers::Ray ray{same.origin, same.direction};
            const Pixel& pixel = reference->at(x, y);
            const std::string where = what + " at " + std::to_string(x) + "," + std::to_string(y);
            Samples at(formula.field, parameters, ray);
            tally.hits += pixel.verdict == Verdict::hit;
            tally.misses += pixel.verdict == Verdict::miss;
            tally.undecided += pixel.verdict == Verdict::undecided;
            long double begin = 0, end = 0;
            for (const render_answers::Span& span : region(ray)) {
                if (span.leave.t <= 0) continue;
                begin = std::max(span.enter.t, 0.0);
                end = span.leave.t;
            }
            if (!(begin < end)) {
                EXPECT_EQ(pixel.verdict, Verdict::miss) << where;
                continue;
            }
            const long double slack = 1e-11L * end;
            begin += slack;  // both sides know the region up to rounding
            end -= slack;
            // Nothing is before a hit or an undecided place, and nothing at all on a miss.
            const long double empty_to = std::min<long double>(end, pixel.near - slack);
            std::optional<WideField::Content> before;
            long double last = begin;
            for (int i = 0; i <= samples && begin < empty_to; ++i) {
                const long double t = begin + (empty_to - begin) * i / samples;
                WideField::Content here = at.at(t);
                const bool surface =
                    before ? at.surface_between(last, *before, t, here) : here.solid.number <= 0;
                if (surface) {
                    ADD_FAILURE() << where << ": a surface before " << static_cast<double>(t)
                                  << " of " << pixel.near;
                    break;
                }
                before = std::move(here);
                last = t;
            }
            if (pixel.verdict != Verdict::hit || pixel.far < begin) continue;
            // And something is at a hit, within the enclosure that is promised, or right beside it
            // where that is a single place.
            EXPECT_LE(pixel.far - pixel.near, 1e-9 * pixel.far) << where;
            const auto between = [&](long double a, long double b) {
                return at.surface_between(a, at.at(a), b, at.at(b));
            };
            EXPECT_TRUE(between(pixel.near, pixel.far) ||
                        between(pixel.near - 1e-12L * end, pixel.far + 1e-12L * end))
                << where << ": nothing between " << pixel.near << " and " << pixel.far;
        }
    }
    return tally;
}

scene::Document preset(const std::string& path) {
    const auto text = base::read_text(std::filesystem::path(ZEROSET_SOURCE_DIR) / "presets" / path,
                                      scene::largest_preset);
    if (!text) return {};
    auto preset = scene::read_preset(*text);
    return preset ? std::move(preset->document) : scene::Document{};
}

TEST(DenseSampling, agrees_with_the_certificates_of_presets) {
    int undecided = 0;
    for (const char* path : {"algebraic/barth_sextic.json",
                             "algebraic/kummer_quartic.json",
                             "algebraic/chmutov_sextic.json",
                             "animated/metaballs.json",
                             "animated/ripples.json",
                             "periodic/gyroid.json",
                             "periodic/scherk_tower.json",
                             "solids/drilled_die.json",
                             "solids/eroded_block.json",
                             "solids/melting_solids.json",
                             "surfaces/heart.json",
                             "surfaces/klein_bottle.json",
                             "surfaces/superquadric.json",
                             "surfaces/whitney_umbrella.json",
                             "operations/bent_bridge.json",
                             "operations/honeycomb.json",
                             "operations/onion.json",
                             "operations/studded_ball.json",
                             "operations/twisted_column.json",
                             "fractals/menger_sponge.json",
                             "fractals/julia_default.json",
                             "fractals/julia_lace.json",
                             "fractals/quaternion_mandelbrot.json"}) {
        const scene::Document document = preset(path);
        const auto formula = compile::compile_formula(document.formula);
        ASSERT_TRUE(formula) << path;
        const Tally tally = check(*formula, document, 12, 9, 400, path);
        EXPECT_GT(tally.hits, 0) << path;
        EXPECT_GT(tally.misses, 0) << path;
        undecided += tally.undecided;
    }
    EXPECT_LE(undecided, 1);
}

TEST(DenseSampling, agrees_with_the_certificates_of_random_scenes) {
    constexpr std::uint64_t seed = 20261122;
    SCOPED_TRACE("seed " + std::to_string(seed));
    eval::Random random(seed);
    Tally all;
    scene::Document document;
    document.camera = Scene{}.camera;
    for (int i = 0; i < 300; ++i) {
        const analysis::RandomScene scene(random, i % 2 == 1);
        compile::Formula formula;
        formula.field = scene.field;
        field::Parameter p;
        p.name = "p";
        p.ids = {graph::ParameterId{1}};
        p.initial = {0.7};
        formula.field.parameters = {p};
        const Tally tally = check(formula, document, 5, 4, 150, "scene " + std::to_string(i));
        all.hits += tally.hits;
        all.misses += tally.misses;
        all.undecided += tally.undecided;
        if (HasFailure()) {
            ADD_FAILURE() << field::print(scene.field);
            return;
        }
    }
    EXPECT_GT(all.hits, 1000);
    EXPECT_GT(all.misses, 1000);
    EXPECT_LT(all.undecided, 600);
    RecordProperty("undecided", all.undecided);
}

}  // namespace
}  // namespace oracle
