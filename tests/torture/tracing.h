// SPDX-License-Identifier: MIT
// What the tracers make of a scene, and what is right.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oracle/metrics.h"
#include "oracle/reference.h"
#include "torture/scene.h"

namespace torture {

/// A way to trace that is recorded under a name.
struct Variant {
    std::string name;
    std::string tracer;
    std::optional<double> epsilon;  ///< in place of the scene's
};

/// Every tracer with the settings of the scene, under its own name; and `auto` at a tenth of the
/// default epsilon, which tells apart what is wrong because rays that pass a surface closely count
/// as hits from what is wrong for another reason.
std::vector<Variant> variants();

/// What a variant makes of a scene on the software driver. Fails the test and returns an empty shot
/// on errors.
oracle::Shot render(const Scene& scene, const Variant& variant, int width, int height);

/// The oracle's answer, fresh. Fails the test and returns an empty reference on errors.
oracle::Reference trace(const Scene& scene, int width, int height);

}  // namespace torture
