// SPDX-License-Identifier: MIT
#include "studio/reference_key.h"

#include <algorithm>

namespace studio {
namespace {

constexpr double most_pixels = 2e6;

int part_of(int side, int divisor) { return std::max(1, (side + divisor / 2) / divisor); }

}  // namespace

ReferenceKey reference_key(const scene::Document& document, const scene::Camera& camera, int width,
                           int height, int divisor) {
    while (static_cast<double>(part_of(width, divisor)) * part_of(height, divisor) > most_pixels) {
        divisor *= 2;
    }
    ReferenceKey key{.width = part_of(width, divisor), .height = part_of(height, divisor)};
    key.scene.formula = document.formula;
    key.scene.parameters = document.parameters;
    key.scene.time = document.time;
    key.scene.bounds = document.bounds;
    key.scene.camera = camera;
    return key;
}

}  // namespace studio
