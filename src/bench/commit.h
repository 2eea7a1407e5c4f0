// SPDX-License-Identifier: MIT
// The source that the program was built from.
#pragma once

#include <string_view>

namespace bench {

/// As `git describe` names it, "-dirty" if files were changed; empty if it was not built from a
/// repository.
std::string_view commit();

}  // namespace bench
