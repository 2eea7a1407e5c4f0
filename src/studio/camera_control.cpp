// SPDX-License-Identifier: MIT
#include "studio/camera_control.h"

#include <cmath>
#include <numbers>

namespace studio {

scene::Camera drag_orbit(const scene::Camera& camera, double right, double down, double height) {
    const double radians = std::numbers::pi / height;
    return scene::orbit(camera, -right * radians, down * radians);
}

scene::Camera drag_pan(const scene::Camera& camera, double right, double down, double height) {
    return scene::pan(camera, -right / height, down / height);
}

scene::Camera wheel_dolly(const scene::Camera& camera, double notches) {
    return scene::dolly(camera, std::pow(0.9, notches));
}

}  // namespace studio
