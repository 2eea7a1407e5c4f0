// SPDX-License-Identifier: MIT
// Blends, maps and copies of solids whose pictures are known.
#pragma once

#include <vector>

#include "render_answers/agreement.h"

namespace render_answers {

std::vector<Answer> operation_answers();

}  // namespace render_answers
