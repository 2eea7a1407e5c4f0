// SPDX-License-Identifier: MIT
#include "oracle/reference_of_depth.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <glm/trigonometric.hpp>

namespace oracle {
namespace {

Pixel pixel_of(float depth) {
    Pixel pixel;
    pixel.near = depth;
    pixel.far = depth;
    if (!(depth >= 0)) {
        pixel.near = 0;
        pixel.far = std::numeric_limits<double>::infinity();
    } else if (std::isinf(depth)) {
        pixel.verdict = Verdict::miss;
    } else {
        pixel.verdict = Verdict::hit;
        pixel.object = 0;
    }
    return pixel;
}

}  // namespace

base::Result<Reference> reference_of_depth(const image::Grey& depth, const image::Vectors& normal,
                                           double fov) {
    const bool has_normals = !normal.values.empty();
    if (has_normals && (normal.width != depth.width || normal.height != depth.height)) {
        return base::error(
            fmt::format("the reference's depth has {}x{} pixels, its normal {}x{}; both must be of "
                        "one picture",
                        depth.width, depth.height, normal.width, normal.height));
    }
    Reference reference;
    reference.width = depth.width;
    reference.height = depth.height;
    reference.pixel_width = 2 * std::tan(glm::radians(fov) / 2) / depth.height;
    reference.pixels.reserve(depth.values.size());
    for (std::size_t i = 0; i < depth.values.size(); ++i) {
        Pixel pixel = pixel_of(depth.values[i]);
        if (has_normals && pixel.verdict == Verdict::hit) {
            const float* n = &normal.values[3 * i];
            pixel.normal = {n[0], n[1], n[2]};
        }
        reference.pixels.push_back(pixel);
    }
    return reference;
}

}  // namespace oracle
