// SPDX-License-Identifier: MIT
// What a user works on, as one value: the same as a preset. Undo is a history of these.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/camera.h"
#include "scene/parameter_value.h"

namespace scene {

/// As many of each as a scene can have.
inline constexpr std::size_t most_lights = 8;
inline constexpr std::size_t most_materials = 16;

/// A directional light. Colours everywhere are linear RGB, usually in [0, 1].
struct Light {
    glm::dvec3 direction{0.5, 1.0, 0.7};  ///< from the scene towards the light; any length but 0
    glm::dvec3 colour{1};
    double intensity = 1;

    friend bool operator==(const Light&, const Light&) = default;
};

/// Blinn-Phong. Object k of a scene uses material k modulo their number.
struct Material {
    glm::dvec3 colour{0.85, 0.55, 0.25};
    double specular = 0.35;  ///< strength of the highlight
    double shininess = 48;   ///< its exponent

    friend bool operator==(const Material&, const Material&) = default;
};

/// Light from everywhere: above, below, and what is seen where there is nothing.
struct Environment {
    glm::dvec3 sky{0.36, 0.42, 0.52};
    glm::dvec3 ground{0.16, 0.13, 0.11};
    glm::dvec3 background_top{0.10, 0.13, 0.19};
    glm::dvec3 background_bottom{0.42, 0.46, 0.52};

    friend bool operator==(const Environment&, const Environment&) = default;
};

/// How the picture is made. The names are those of the preset and of the command line.
struct Settings {
    std::string tracer = "auto";
    std::string precision = "auto";  ///< or "single", "double"
    int steps = 1024;                ///< at most so many per ray
    double lipschitz = 1;            ///< every step is divided by it: above 1 slower and safer
    double epsilon = 0.1;            ///< a hit is closer than this part of a pixel's footprint
    double shadow = 12;              ///< shadow factor k: small is soft, large is hard
    bool shadows = true;
    bool ambient_occlusion = true;
    bool grid = false;              ///< the ground grid
    bool show_steps = false;        ///< colour the number of steps instead of shading
    bool show_certificate = false;  ///< colour what is proven instead of all else
    double exposure = 1;

    friend bool operator==(const Settings&, const Settings&) = default;
};

struct Document {
    std::string title;
    std::string description;
    std::string formula;         ///< lines separated by '\n'
    ParameterValues parameters;  ///< those moved away from the formula's defaults
    double time = 0;             ///< t in seconds
    Bounds bounds;
    std::optional<Camera> camera;  ///< none: frame_all
    std::vector<Light> lights{Light{}};
    std::vector<Material> materials{Material{}};  ///< at least one
    Environment environment;
    Settings settings;
    /// Fields of a preset that this version does not know, as compact JSON text by JSON pointer;
    /// written back on saving where the object that they belong to is still there.
    std::map<std::string, std::string> unknown;

    friend bool operator==(const Document&, const Document&) = default;
};

/// The document's camera, or the framing one where it has none.
Camera camera_of(const Document& document, double aspect);

}  // namespace scene
