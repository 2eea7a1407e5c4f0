// SPDX-License-Identifier: MIT
// Older versions of presets, brought to the present one.
#pragma once

#include "scene/json.h"
#include "scene/preset.h"

namespace scene {

/// The preset as the present version would have written it. `version` is from 1 to preset_version.
/// Spans stay those of the file.
Json migrate(Json preset, int version);

}  // namespace scene
