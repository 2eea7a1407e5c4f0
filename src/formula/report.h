// SPDX-License-Identifier: MIT
// Puts what was found wrong in a text in the order in which people read it.
#pragma once

#include "base/diagnostic.h"

namespace formula {

/// Sorted by place, at most max_errors of them.
base::Diagnostics in_order(base::Diagnostics diagnostics);

}  // namespace formula
