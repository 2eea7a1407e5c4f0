// SPDX-License-Identifier: MIT
#include "torture/exact_answer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace torture {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const std::map<std::string, ExactShape>& table() {
    static const std::map<std::string, ExactShape> shapes{
        {"creases/touching_maximum", ExactSphere{}},
        {"edges/root_at_the_edge", ExactSphere{}},
        {"even_roots/absolute_sphere", ExactSphere{}},
        {"even_roots/circle", ExactNothing{}},
        {"even_roots/plane_squared", ExactPlane{{1, 2, 3}, 0}},
        {"even_roots/ridge_of_an_exponential", ExactPlane{{1, 0, 1}, 0}},
        {"even_roots/sphere_lifted", ExactNothing{}},
        {"even_roots/sphere_multiplied_out", ExactSphere{}},
        {"even_roots/sphere_squared", ExactSphere{}},
        {"exponentials/large_factor", ExactSphere{}},
        {"exponentials/saturated", ExactSphere{}},
        {"exponentials/small_factor", ExactSphere{}},
        {"eye/inside_a_formula", ExactAtEye{}},
        {"eye/inside_a_sheet", ExactSphere{}},
        {"eye/inside_a_solid", ExactAtEye{}},
        {"eye/just_above_the_surface", ExactPlane{{0, 1, 0}, 0}},
        {"eye/on_the_surface", ExactAtEye{}},
        {"grazing/plane_along_its_length", ExactPlane{{0, 1, 0}, 0}},
        {"grazing/solid_plane", ExactPlane{{0, 1, 0}, -0.1}},
        {"grazing/tangent_ball", ExactSphere{}},
        {"poles/near_a_pole", ExactSphere{glm::dvec3(0), std::sqrt(1.2)}},
        {"poles/plain_pole", ExactNothing{}},
        {"regions/empty", ExactNothing{}},
        {"regions/full", ExactBounds{}},
        {"regions/zero", ExactBounds{}},
        {"scales/ball_at_1e4", ExactSphere{glm::dvec3(1e4), 1}},
        {"scales/grain_far_off", ExactSphere{{0.3, 0.2, 0.1}, 1e-4}},
        {"scales/planet", ExactSphere{{0, -1e4, 0}, 1e4}},
        {"scales/sphere_at_1e4", ExactSphere{glm::dvec3(1e4), 1}},
        {"scales/sphere_of_1e-4", ExactSphere{glm::dvec3(0), 1e-4}},
        {"vanishing_gradients/plane_through_flatness", ExactPlane{{2, 1, 1}, 0.1}},
        {"vanishing_gradients/sphere_cubed", ExactSphere{}},
        {"views/tenth_of_a_degree", ExactSphere{}},
        {"walls/two_planes", ExactPlane{{0, 0, 1}, 1e-4}},
        {"walls/two_spheres", ExactSphere{}},
    };
    return shapes;
}

struct Ray {
    glm::dvec3 eye;
    glm::dvec3 direction;  ///< unit
};

/// Ray through a point of the picture, in pixels from the left and the top.
class Rays {
public:
    Rays(const scene::Document& document, int width, int height)
        : camera_(scene::camera_of(document, static_cast<double>(width) / height)),
          axes_(scene::axes(camera_)),
          width_(width),
          height_(height) {}

    double pixel_width() const { return 2 * slope() / height_; }

    Ray through(double x, double y) const {
        const double across = slope() * (2 * x / width_ - 1) * width_ / height_;
        const double up = slope() * (1 - 2 * y / height_);
        return {camera_.eye, glm::normalize(axes_.w + across * axes_.u + up * axes_.v)};
    }

private:
    double slope() const { return std::tan(glm::radians(camera_.fov) / 2); }

    scene::Camera camera_;
    scene::Axes axes_;
    int width_;
    int height_;
};

struct Crossing {
    double depth;
    glm::dvec3 normal;  ///< of any length and side
};

/// Both crossings with a sphere, the nearer one first; none if the ray passes by.
std::vector<Crossing> cross(const ExactSphere& sphere, const Ray& ray) {
    const glm::dvec3 from = ray.eye - sphere.centre;
    const double b = glm::dot(from, ray.direction);
    const double length = glm::length(from);
    const double c = (length - sphere.radius) * (length + sphere.radius);
    const double root = b * b - c;
    if (root < 0) return {};
    // The form that does not cancel for the crossing near the eye.
    const double q = b > 0 ? -b - std::sqrt(root) : -b + std::sqrt(root);
    std::array<double, 2> depths{q, q == 0 ? 0 : c / q};
    if (depths[0] > depths[1]) std::swap(depths[0], depths[1]);
    return {{depths[0], from + depths[0] * ray.direction},
            {depths[1], from + depths[1] * ray.direction}};
}

std::vector<Crossing> cross(const ExactPlane& plane, const Ray& ray) {
    const double along = glm::dot(plane.normal, ray.direction);
    if (along == 0) return {};
    return {{(plane.offset - glm::dot(plane.normal, ray.eye)) / along, plane.normal}};
}

/// What of a ray is in bounds, which are balls or nothing in these scenes.
std::array<double, 2> part_in_bounds(const scene::Bounds& bounds, const Ray& ray) {
    if (bounds.shape == scene::Bounds::Shape::none) return {0, scene::far_distance};
    const auto ends = cross(ExactSphere{bounds.centre, bounds.half.x}, ray);
    if (ends.empty()) return {infinity, -infinity};
    return {std::max(0.0, ends[0].depth), ends[1].depth};
}

std::optional<Crossing> first_of(const std::vector<Crossing>& crossings,
                                 const std::array<double, 2>& part) {
    for (const Crossing& crossing : crossings) {
        if (crossing.depth >= part[0] && crossing.depth <= part[1]) return crossing;
    }
    return std::nullopt;
}

struct FirstHit {
    const scene::Bounds& bounds;
    const Ray& ray;

    std::optional<Crossing> operator()(const ExactSphere& sphere) const {
        return first_of(cross(sphere, ray), part_in_bounds(bounds, ray));
    }
    std::optional<Crossing> operator()(const ExactPlane& plane) const {
        return first_of(cross(plane, ray), part_in_bounds(bounds, ray));
    }
    std::optional<Crossing> operator()(const ExactBounds&) const {
        return (*this)(ExactSphere{bounds.centre, bounds.half.x});
    }
    std::optional<Crossing> operator()(const ExactAtEye&) const {
        return Crossing{0, -ray.direction};
    }
    std::optional<Crossing> operator()(const ExactNothing&) const { return std::nullopt; }
};

oracle::Pixel pixel_of(const std::optional<Crossing>& hit, const Ray& ray) {
    oracle::Pixel pixel;
    pixel.verdict = hit ? oracle::Verdict::hit : oracle::Verdict::miss;
    pixel.near = pixel.far = hit ? hit->depth : infinity;
    if (!hit) return pixel;
    pixel.object = 0;
    pixel.normal = glm::normalize(hit->normal);
    if (glm::dot(pixel.normal, ray.direction) > 0) pixel.normal = -pixel.normal;
    return pixel;
}

bool differs(const std::optional<Crossing>& a, const std::optional<Crossing>& b,
             double pixel_width) {
    if (!a || !b) return a.has_value() != b.has_value();
    return std::abs(a->depth - b->depth) > 0.5 * pixel_width * a->depth;
}

}  // namespace

std::optional<ExactShape> exact_shape(const std::string& scene_name) {
    const auto found = table().find(scene_name);
    return found == table().end() ? std::nullopt : std::optional(found->second);
}

std::vector<std::string> exact_scene_names() {
    std::vector<std::string> names;
    for (const auto& [name, shape] : table()) names.push_back(name);
    return names;
}

oracle::Reference exact_reference(const ExactShape& shape, const scene::Document& document,
                                  int width, int height) {
    const Rays rays(document, width, height);
    const auto hit_at = [&](double x, double y) {
        const Ray ray = rays.through(x, y);
        return std::visit(FirstHit{document.bounds, ray}, shape);
    };
    oracle::Reference reference{
        .width = width, .height = height, .pixel_width = rays.pixel_width(), .pixels = {}};
    for (int j = 0; j < height; ++j) {
        for (int i = 0; i < width; ++i) {
            const auto hit = hit_at(i + 0.5, j + 0.5);
            oracle::Pixel pixel = pixel_of(hit, rays.through(i + 0.5, j + 0.5));
            for (int k = 0; k < 9; ++k) {
                const auto beside =
                    hit_at(i + 0.5 + 0.03 * (k % 3 - 1), j + 0.5 + 0.03 * (k / 3 - 1));
                if (differs(hit, beside, reference.pixel_width)) pixel.fragile = true;
            }
            reference.pixels.push_back(pixel);
        }
    }
    return reference;
}

void decide(oracle::Reference& reference, const oracle::Reference& answer) {
    for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
        oracle::Pixel& pixel = reference.pixels[i];
        if (pixel.verdict == oracle::Verdict::undecided) pixel = answer.pixels[i];
    }
}

}  // namespace torture
