// SPDX-License-Identifier: MIT
// Depths from anywhere as a reference.
#pragma once

#include "base/result.h"
#include "image/image.h"
#include "oracle/reference.h"

namespace oracle {

/// Takes a picture of depths at its word: +infinity is a miss, what is no depth (NaN, negative) is
/// undecided, all else a hit, and nothing is fragile. `normal` may be empty. `fov` is the full
/// picture's vertical angle in degrees, and the picture must be a full one. Error: another size of
/// the normals.
base::Result<Reference> reference_of_depth(const image::Grey& depth, const image::Vectors& normal,
                                           double fov);

}  // namespace oracle
