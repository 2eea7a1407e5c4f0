// SPDX-License-Identifier: MIT
// Pictures of a reference.
#pragma once

#include "compile/compile.h"
#include "image/image.h"
#include "oracle/reference.h"
#include "oracle/trace.h"

namespace oracle {

/// The lit surface, as `render` draws it without shadows.
image::Picture shaded_picture(const Reference& reference, const compile::Formula& formula,
                              const scene::Document& document, const Query& query);

/// What is proven, a colour each: a hit light grey, a miss dark blue, undecided magenta, fragile
/// yellow, a hit that rests on estimates orange, a miss that does brown.
image::Picture certificate_picture(const Reference& reference);

/// Distances; +infinity for a miss.
image::Grey depths(const Reference& reference);
/// Unit normals; 0 for a miss.
image::Vectors normals(const Reference& reference);

}  // namespace oracle
