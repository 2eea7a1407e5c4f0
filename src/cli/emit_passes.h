// SPDX-License-Identifier: MIT
// What `zeroset emit --what graph` prints: a formula on its way through the passes.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"

namespace cli {

/// The field as it was lowered and after each pass that changes it, one line a node, each with the
/// number of its operations; at the end what is computed at each point and what once a frame. For
/// people; the form may change.
base::Result<std::string> emit_passes(std::string_view formula);

}  // namespace cli
