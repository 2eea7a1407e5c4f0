// SPDX-License-Identifier: MIT
// Scenes that are written by a program, for measuring how cost grows.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/document.h"

namespace bench {

/// So many balls on a spiral in a disc, a fifth of them cut out of the blended others, all of a
/// size that covers about the same share of the picture.
std::string many_primitives(int count);

/// The names that measuring knows beside those of presets.
inline constexpr std::string_view few_name = "generated/primitives_10";
inline constexpr std::string_view many_name = "generated/primitives_1000";

/// The scene of such a name; none for all others.
std::optional<scene::Document> generated_scene(std::string_view name);

}  // namespace bench
