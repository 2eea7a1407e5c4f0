// SPDX-License-Identifier: MIT
// First roots along rays found by brute force in double precision: an answer for smooth formulas
// that have no closed one. Not certified: two roots closer than a sample are missed.
#pragma once

#include "compile/compile.h"
#include "render_answers/ray.h"
#include "scene/document.h"

namespace render_answers {

/// How a picture agrees with dense sampling, outside of the pixels beside a silhouette.
struct SampledAgreement {
    int compared = 0;
    int missed = 0;
    int phantom = 0;
    int moved = 0;       ///< the depth is off by more than a relative 1e-4
    int unresolved = 0;  ///< in the whole picture
    int hit = 0;
};

/// Renders a document of one smooth formula and compares each pixel with `samples` values of f
/// along its ray inside of the bounds.
SampledAgreement compare_with_samples(const scene::Document& document, int width, int height,
                                      int samples);

}  // namespace render_answers
