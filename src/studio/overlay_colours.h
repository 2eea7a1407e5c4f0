// SPDX-License-Identifier: MIT
// The colours of wrong pixels on the screen.
#pragma once

#include <imgui.h>

#include "oracle/marked_picture.h"

namespace studio {

/// That of oracle::mark_of; transparent where there is none.
inline ImU32 overlay_colour(oracle::Judgement judgement, int alpha) {
    const auto mark = oracle::mark_of(judgement);
    return mark ? IM_COL32((*mark)[0], (*mark)[1], (*mark)[2], alpha) : 0;
}

}  // namespace studio
