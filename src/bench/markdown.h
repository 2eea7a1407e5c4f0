// SPDX-License-Identifier: MIT
// Tables in Markdown.
#pragma once

#include <string>
#include <vector>

namespace bench {

/// Rows of cells; the first row is the head. The first column is left-aligned, all others right.
/// An empty text without rows below the head.
std::string markdown_table(const std::vector<std::vector<std::string>>& rows);

}  // namespace bench
