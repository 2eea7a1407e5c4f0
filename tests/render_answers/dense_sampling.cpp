// SPDX-License-Identifier: MIT
#include "render_answers/dense_sampling.h"

#include <cmath>
#include <limits>

#include "eval/tape.h"
#include "render_answers/exact_shape.h"
#include "render_answers/shot.h"

namespace render_answers {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The value of a formula with a single leaf.
class Value {
public:
    Value(const compile::Formula& formula, const scene::Document& document)
        : tape_(tape_of(formula.field)) {
        const std::vector<double> parameters = compile::parameter_values(formula.field, document);
        eval::load_parameters<double>(tape_, parameters, registers_);
    }

    double operator()(const glm::dvec3& p) {
        const std::array<double, 3> point{p.x, p.y, p.z};
        double value = 0;
        eval::evaluate_loaded<double>(tape_, point, std::span<double>(&value, 1), registers_);
        return value;
    }

private:
    static eval::Tape tape_of(const field::Field& field) {
        const auto& leaf = std::get<field::Formula>(field[field.root]);
        return eval::make_tape(field.graph, std::array{leaf.value});
    }

    eval::Tape tape_;
    std::vector<double> registers_;
};

double first_root(Value& value, const Ray& ray, double begin, double end, int samples) {
    double a = begin;
    double f = value(ray.at(a));
    for (int k = 1; k <= samples; ++k) {
        double b = begin + (end - begin) * k / samples;
        const double g = value(ray.at(b));
        if ((f > 0) != (g > 0)) {
            for (int round = 0; round < 60; ++round) {
                const double middle = (a + b) / 2;
                ((value(ray.at(middle)) > 0) == (f > 0) ? a : b) = middle;
            }
            return b;
        }
        a = b;
        f = g;
    }
    return infinity;
}

/// True if the depth is no smooth function of the place around a pixel.
bool beside_silhouette(const image::Image<double, 1>& depths, int i, int j) {
    const double centre = *depths.at(i, j);
    double least = infinity;
    double most = 0;
    for (int b = std::max(j - 1, 0); b <= std::min(j + 1, depths.height - 1); ++b) {
        for (int a = std::max(i - 1, 0); a <= std::min(i + 1, depths.width - 1); ++a) {
            const double depth = *depths.at(a, b);
            if (std::isfinite(depth) != std::isfinite(centre)) return true;
            least = std::min(least, depth);
            most = std::max(most, depth);
        }
    }
    return std::isfinite(centre) && most - least > 0.02 * centre;
}

}  // namespace

SampledAgreement compare_with_samples(const scene::Document& document, int width, int height,
                                      int samples) {
    const auto formula = compile::compile_formula(document.formula);
    if (!formula) return {};
    const scene::Camera camera = scene::camera_of(document, static_cast<double>(width) / height);
    const Solid region = inside(document.bounds);
    Value value(*formula, document);
    image::Image<double, 1> depths(width, height);
    for (int j = 0; j < height; ++j) {
        for (int i = 0; i < width; ++i) {
            const Ray ray = ray_through(camera, width, height, i + 0.5, j + 0.5);
            *depths.at(i, j) = infinity;
            for (const Span& span : region(ray)) {
                if (span.leave.t <= 0) continue;
                *depths.at(i, j) =
                    first_root(value, ray, std::max(span.enter.t, 0.0), span.leave.t, samples);
            }
        }
    }
    const render::Still still = render(document, render::whole(width, height),
                                       {.picture = false, .geometry = true, .normal = true});
    SampledAgreement agreement;
    agreement.unresolved = count(still, shader::Status::unresolved);
    agreement.hit = count(still, shader::Status::hit);
    for (int j = 0; j < height; ++j) {
        for (int i = 0; i < width; ++i) {
            if (beside_silhouette(depths, i, j)) continue;
            ++agreement.compared;
            const double expected = *depths.at(i, j);
            const double actual = depth(still, i, j);
            agreement.missed += std::isfinite(expected) && !std::isfinite(actual);
            agreement.phantom += !std::isfinite(expected) && std::isfinite(actual);
            agreement.moved += std::isfinite(expected) && std::isfinite(actual) &&
                               std::abs(actual - expected) > 1e-4 * expected;
        }
    }
    return agreement;
}

}  // namespace render_answers
