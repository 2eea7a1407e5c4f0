// SPDX-License-Identifier: MIT
// A picture of where another picture is wrong.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "image/image.h"
#include "oracle/metrics.h"
#include "oracle/reference.h"

namespace oracle {

/// 8-bit sRGB.
using Mark = std::array<std::uint8_t, 3>;

/// The colour of a judgement: missed red, phantom blue, moved yellow, excused violet; none for what
/// is right.
std::optional<Mark> mark_of(Judgement judgement);

/// The reference's depths in grey, near ones bright, misses dark; over them each pixel that is not
/// right in the colour of its judgement. The metrics must be of this reference.
image::Picture marked_picture(const Reference& reference, const Metrics& metrics);

}  // namespace oracle
