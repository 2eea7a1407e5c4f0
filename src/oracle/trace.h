// SPDX-License-Identifier: MIT
// The reference picture of a scene, on all cores.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "base/result.h"
#include "compile/compile.h"
#include "oracle/reference.h"
#include "scene/document.h"

namespace oracle {

struct Query {
    int width = 320;  ///< of the full picture
    int height = 240;
    std::optional<std::array<int, 4>> region;  ///< x, y, width, height; none: all
    int threads = 0;                           ///< 0: as many as there are cores
    /// Told the finished fraction now and then, from any thread; false gives up. May be empty.
    std::function<bool(double)> progress;
};

/// Rays and pixels are those of the program that draws. Errors: a size out of range, a region
/// outside of the picture, given up.
base::Result<Reference> trace(const compile::Formula& formula, const scene::Document& document,
                              const Query& query);

}  // namespace oracle
