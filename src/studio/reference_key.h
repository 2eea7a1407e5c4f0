// SPDX-License-Identifier: MIT
// What a reference picture depends on.
#pragma once

#include "scene/document.h"

namespace studio {

/// Two equal keys have equal references: tracer, Lipschitz scale, steps, epsilon, lights and
/// colours are not in it.
struct ReferenceKey {
    /// Formula, parameters, time, region and an explicit camera; all else by default.
    scene::Document scene{};
    int width = 0, height = 0;  ///< of the reference, in pixels

    friend bool operator==(const ReferenceKey&, const ReferenceKey&) = default;
};

/// The parts of the sides of the picture in the window that a check can have.
inline constexpr int check_divisors[] = {8, 4, 2, 1};

/// The document as this camera sees it, in 1/divisor of the width and of the height. A picture of
/// more than 2 million pixels is checked in the next smaller size, so that a reference stays below
/// about 100 MB.
ReferenceKey reference_key(const scene::Document& document, const scene::Camera& camera, int width,
                           int height, int divisor);

}  // namespace studio
