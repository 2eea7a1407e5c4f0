// SPDX-License-Identifier: MIT
// The numbers of one frame, laid out as the uniform block `Frame` of shaders/common/frame.glsl.
#pragma once

#include <array>
#include <cstddef>

#include <glm/vec4.hpp>

#include "scene/document.h"

namespace render {

inline constexpr std::size_t max_lights = scene::most_lights;
inline constexpr std::size_t max_materials = scene::most_materials;

/// The full picture's size, and the part of it that is drawn, in pixels from the left and the top.
struct View {
    int width = 1280;
    int height = 720;
    int x = 0;
    int y = 0;
    int region_width = 1280;
    int region_height = 720;
};
/// The full picture.
View whole(int width, int height);

/// Only vec4, as std140 has them in single and in double precision. Lights and materials beyond the
/// maximum are dropped.
struct Frame {
    glm::dvec4 eye;                ///< xyz, tan(fov / 2)
    glm::dvec4 right;              ///< the camera's axis u, the width of a pixel at the distance 1
    glm::dvec4 up;                 ///< the axis v, 1 / the Lipschitz scale
    glm::dvec4 forward;            ///< the axis w, 1/64 of the bounds' half diagonal
    glm::dvec4 picture;            ///< width, height of the full picture; x, y of the part drawn
    glm::dvec4 bounds_centre;      ///< xyz, distance at which rays end
    glm::dvec4 bounds_half;        ///< xyz (a sphere's radius in all), height of the ground grid
    glm::dvec4 march;              ///< steps, Lipschitz scale, epsilon, shadow factor
    glm::dvec4 sky;                ///< rgb, number of lights
    glm::dvec4 ground;             ///< rgb, number of materials
    glm::dvec4 background_top;     ///< rgb, exposure
    glm::dvec4 background_bottom;  ///< rgb, unused
    glm::dvec4 passes;  ///< set by Canvas: first pass, pixels kept per pixel along x and y, unused
    glm::dvec4 origin;  ///< of the program's coordinates, which part of the scene is seen
    std::array<glm::dvec4, max_lights> light_direction;        ///< unit, towards the light; unused
    std::array<glm::dvec4, max_lights> light_colour;           ///< rgb times intensity; unused
    std::array<glm::dvec4, max_materials> material;            ///< rgb, specular strength; repeated
    std::array<glm::dvec4, max_materials> material_shininess;  ///< exponent, three unused
};

/// Which part of the scene is seen: the distance of the target over half of the diagonal of the
/// bounds, at most 1. Rounded once, when it is handed to a program. Light directions become unit
/// vectors (a zero one stays zero: no light). Rays end where they surely have left the bounds, or
/// at scene::far_distance; the ground grid lies at the bottom of the bounds, or at -2. No materials
/// means one by default.
Frame frame(const scene::Document& document, const scene::Camera& camera, const View& view);

/// The same frame in coordinates about another origin.
Frame about(Frame frame, const std::array<double, 3>& origin);

}  // namespace render
