// SPDX-License-Identifier: MIT
// What mouse and wheel on the picture do to the camera.
#pragma once

#include "scene/camera.h"

namespace studio {

/// Turns around the target by a drag of so many pixels in a picture of this height: the point under
/// the mouse follows it, half a turn for the whole height.
scene::Camera drag_orbit(const scene::Camera& camera, double right, double down, double height);
/// Moves along the picture's plane: what is at the target's depth stays under the mouse.
scene::Camera drag_pan(const scene::Camera& camera, double right, double down, double height);
/// One notch of the wheel forward comes a tenth nearer.
scene::Camera wheel_dolly(const scene::Camera& camera, double notches);

}  // namespace studio
