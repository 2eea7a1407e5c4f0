// SPDX-License-Identifier: MIT
#include "oracle/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "compile/parameter_values.h"
#include "eval/field_value.h"
#include "eval/tape.h"
#include "field/parts.h"
#include "oracle/ray.h"

namespace oracle {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

constexpr Rgb magenta{255, 0, 255};

/// The sRGB transfer function (IEC 61966-2-1).
std::uint8_t encoded(double light) {
    const double c = std::clamp(light, 0.0, 1.0);
    const double s = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255 * s));
}

/// An object: its leaf, and the cells that it is in, outermost first.
struct Object {
    field::FieldId leaf{};
    std::vector<field::FieldId> cells;
};

/// All objects below a node, from left to right.
void collect(const field::Field& field, field::FieldId id, std::vector<field::FieldId> cells,
             std::vector<Object>& list) {
    const std::vector<field::FieldId> below = field::children(field[id]);
    if (below.empty()) list.push_back({id, cells});
    if (std::holds_alternative<field::Cells>(field[id])) cells.push_back(id);
    for (const field::FieldId child : below) collect(field, child, cells, list);
}

/// The light that a pixel shows: shaders/light/ in double precision, without shadows.
class Shading {
public:
    Shading(const compile::Formula& formula, const scene::Document& document)
        : field_(formula.field),
          document_(document),
          parameters_(compile::parameter_values(field_, document)) {
        collect(field_, field_.root, {}, objects_);
    }

    glm::dvec3 background(double height) const {
        const scene::Environment& around = document_.environment;
        return glm::mix(around.background_bottom, around.background_top,
                        std::clamp(0.5 + 0.5 * height, 0.0, 1.0));
    }

    glm::dvec3 lit(const Pixel& pixel, const Ray& ray) const {
        const std::size_t object = static_cast<std::size_t>(std::max(pixel.object, 0));
        const scene::Material& material = document_.materials[object % document_.materials.size()];
        const glm::dvec3 colour =
            own_colour(object, ray.at(pixel.depth())).value_or(material.colour);
        const scene::Environment& around = document_.environment;
        const glm::dvec3& n = pixel.normal;
        glm::dvec3 light = glm::mix(around.ground, around.sky, 0.5 + 0.5 * n.y) * colour;
        for (const scene::Light& source : document_.lights) {
            const glm::dvec3 l = glm::normalize(source.direction);
            const double facing = glm::dot(n, l);
            if (!(facing > 0)) continue;
            const glm::dvec3 halfway = glm::normalize(l - ray.direction);
            const double highlight =
                material.specular *
                std::pow(std::max(glm::dot(n, halfway), 0.0), material.shininess);
            light += source.colour * source.intensity * (colour * facing + highlight);
        }
        return light;
    }

private:
    glm::dvec3 values(const std::array<graph::NodeId, 3>& roots, glm::dvec3 point) const {
        const auto at = [&](std::size_t i) {
            return eval::evaluate(field_.graph, roots[i], point, parameters_);
        };
        return {at(0), at(1), at(2)};
    }
    /// That of the outermost cells that have one, else that of the leaf.
    std::optional<glm::dvec3> own_colour(std::size_t number, glm::dvec3 point) const {
        if (number >= objects_.size()) return std::nullopt;
        for (const field::FieldId id : objects_[number].cells) {
            const auto& cells = std::get<field::Cells>(field_[id]);
            // fmax: what is negative or undefined counts as 0.
            if (cells.colour) {
                const glm::dvec3 colour = values(*cells.colour, point);
                return glm::dvec3(std::fmax(colour.x, 0), std::fmax(colour.y, 0),
                                  std::fmax(colour.z, 0));
            }
            point = values(cells.point, point);
        }
        return eval::colour(field_, objects_[number].leaf, point, parameters_);
    }

    const field::Field& field_;
    const scene::Document& document_;
    std::vector<Object> objects_;
    std::vector<double> parameters_;
};

Rgb certificate_colour(const Pixel& pixel) {
    if (pixel.verdict == Verdict::undecided) return magenta;
    if (pixel.fragile) return {255, 210, 0};
    if (pixel.verdict == Verdict::hit) {
        return pixel.estimated ? Rgb{235, 130, 40} : Rgb{215, 215, 215};
    }
    return pixel.estimated ? Rgb{75, 45, 30} : Rgb{25, 35, 80};
}

template <class Colour>
image::Picture picture(const Reference& reference, Colour colour) {
    image::Picture result(reference.width, reference.height);
    for (int y = 0; y < reference.height; ++y) {
        for (int x = 0; x < reference.width; ++x) {
            const Rgb rgb = colour(x, y, reference.at(x, y));
            std::copy(rgb.begin(), rgb.end(), result.at(x, y));
        }
    }
    return result;
}

}  // namespace

image::Picture shaded_picture(const Reference& reference, const compile::Formula& formula,
                              const scene::Document& document, const Query& query) {
    const Shading shading(formula, document);
    const scene::Camera camera =
        scene::camera_of(document, static_cast<double>(query.width) / query.height);
    const Pinhole pinhole(camera, query.width, query.height);
    const glm::dvec3 up = scene::axes(camera).v;
    const double slope = 0.5 * query.height * pinhole.pixel_width();
    const int left = query.region ? (*query.region)[0] : 0;
    const int top = query.region ? (*query.region)[1] : 0;
    return picture(reference, [&](int x, int y, const Pixel& pixel) -> Rgb {
        const Ray ray = pinhole.through(left + x + 0.5, top + y + 0.5);
        const double height = glm::dot(ray.direction, up) / std::max(slope, 1e-6);
        const glm::dvec3 light =
            document.settings.exposure *
            (pixel.verdict == Verdict::miss ? shading.background(height) : shading.lit(pixel, ray));
        return {encoded(light.x), encoded(light.y), encoded(light.z)};
    });
}

image::Picture certificate_picture(const Reference& reference) {
    return picture(reference,
                   [&](int, int, const Pixel& pixel) { return certificate_colour(pixel); });
}

image::Grey depths(const Reference& reference) {
    image::Grey result(reference.width, reference.height);
    std::ranges::transform(reference.pixels, result.values.begin(), [](const Pixel& pixel) {
        return pixel.verdict == Verdict::miss ? INFINITY : static_cast<float>(pixel.depth());
    });
    return result;
}

image::Vectors normals(const Reference& reference) {
    image::Vectors result(reference.width, reference.height);
    float* to = result.values.data();
    for (const Pixel& pixel : reference.pixels) {
        for (int i = 0; i < 3; ++i) *to++ = static_cast<float>(pixel.normal[i]);
    }
    return result;
}

}  // namespace oracle
