// SPDX-License-Identifier: MIT
// Where results are written.
#pragma once

#include <string>

#include "base/result.h"

namespace cli {

/// An error if a file cannot be made there: asked before a long run instead of after it.
base::Status check_writable(const std::string& path);

}  // namespace cli
