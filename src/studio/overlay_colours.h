// SPDX-License-Identifier: MIT
// The colours of wrong pixels on the screen.
#pragma once

#include <imgui.h>

#include "oracle/marked_picture.h"

namespace studio {

/// That of oracle::mark_of, nearly opaque.
inline ImU32 overlay_colour(oracle::Judgement judgement) {
    const auto mark = oracle::mark_of(judgement);
    return mark ? IM_COL32((*mark)[0], (*mark)[1], (*mark)[2], 230) : 0;
}

}  // namespace studio
