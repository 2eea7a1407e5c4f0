// SPDX-License-Identifier: MIT
// Other formulas for the same surface, without what keeps the oracle from deciding.
#pragma once

#include <optional>
#include <string>

#include "torture/scene.h"

namespace torture {

/// The scene with a formula that has the same zeros, as a simple root and without a pole or a jump;
/// none if the scene has no such twin.
std::optional<Scene> twin_of(const Scene& scene);

}  // namespace torture
