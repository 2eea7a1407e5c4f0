// SPDX-License-Identifier: MIT
// What the tracers make of a scene, and what is right.
#pragma once

#include <string>

#include "oracle/metrics.h"
#include "oracle/reference.h"
#include "torture/scene.h"

namespace torture {

/// What a tracer makes of a scene on the software driver. Fails the test and returns an empty shot
/// on errors.
oracle::Shot render(const Scene& scene, const std::string& tracer, int width, int height);

/// The oracle's answer, fresh. Fails the test and returns an empty reference on errors.
oracle::Reference trace(const Scene& scene, int width, int height);

}  // namespace torture
