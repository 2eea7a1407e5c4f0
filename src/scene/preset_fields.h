// SPDX-License-Identifier: MIT
// The one table of a preset's plain fields: names, members and ranges. Reading, writing and the
// sliders of the studio follow it.
#pragma once

#include <array>
#include <string_view>
#include <variant>

#include "scene/document.h"

namespace scene {

/// Both ends belong to it.
struct Range {
    double least = 0;
    double greatest = 0;
};

inline constexpr Range any_number{-1e300, 1e300};
inline constexpr Range position_range{-1e6, 1e6};
inline constexpr Range size_range{1e-6, 1e6};
inline constexpr Range colour_range{0, 100};

/// A field of an object that is a member of a type. The range is for numbers, and for each
/// component of vectors.
template <class Owner>
struct Field {
    using Member = std::variant<bool Owner::*, int Owner::*, double Owner::*, std::string Owner::*,
                                glm::dvec3 Owner::*>;
    std::string_view name;
    Member member;
    Range range{};
    bool required = false;  ///< an error if it is missing, and always written
};

inline constexpr std::array camera_fields{
    Field<Camera>{"eye", &Camera::eye, position_range, true},
    Field<Camera>{"target", &Camera::target, position_range, true},
    Field<Camera>{"up", &Camera::up, position_range},
    Field<Camera>{"fov", &Camera::fov, {least_fov, greatest_fov}},
};

inline constexpr std::array light_fields{
    Field<Light>{"direction", &Light::direction, position_range},
    Field<Light>{"colour", &Light::colour, colour_range},
    Field<Light>{"intensity", &Light::intensity, {0, 100}},
};

inline constexpr std::array material_fields{
    Field<Material>{"colour", &Material::colour, colour_range},
    Field<Material>{"specular", &Material::specular, {0, 10}},
    Field<Material>{"shininess", &Material::shininess, {1, 10000}},
};

inline constexpr std::array environment_fields{
    Field<Environment>{"sky", &Environment::sky, colour_range},
    Field<Environment>{"ground", &Environment::ground, colour_range},
    Field<Environment>{"background_top", &Environment::background_top, colour_range},
    Field<Environment>{"background_bottom", &Environment::background_bottom, colour_range},
};

inline constexpr std::array settings_fields{
    Field<Settings>{"tracer", &Settings::tracer},
    Field<Settings>{"precision", &Settings::precision},
    Field<Settings>{"steps", &Settings::steps, {1, 100000}},
    Field<Settings>{"lipschitz", &Settings::lipschitz, {0.001, 1000}},
    Field<Settings>{"epsilon", &Settings::epsilon, {1e-6, 100}},
    Field<Settings>{"shadow", &Settings::shadow, {0.01, 1000}},
    Field<Settings>{"shadows", &Settings::shadows},
    Field<Settings>{"ambient_occlusion", &Settings::ambient_occlusion},
    Field<Settings>{"grid", &Settings::grid},
    Field<Settings>{"show_steps", &Settings::show_steps},
    Field<Settings>{"show_certificate", &Settings::show_certificate},
    Field<Settings>{"exposure", &Settings::exposure, {0, 100}},
};

}  // namespace scene
