// SPDX-License-Identifier: MIT
#include "bench/markdown.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace bench {

std::string markdown_table(const std::vector<std::vector<std::string>>& rows) {
    if (rows.size() < 2) return "";
    std::string text;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        text += fmt::format("| {} |\n", fmt::join(rows[i], " | "));
        if (i > 0) continue;
        text += "| --- |";
        for (std::size_t k = 1; k < rows[0].size(); ++k) text += " ---: |";
        text += '\n';
    }
    return text + '\n';
}

}  // namespace bench
