// SPDX-License-Identifier: MIT
// What the program is asked to reach, and whether a run did.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/pages.h"
#include "bench/report.h"

namespace bench {

struct Target {
    std::string what;
    std::string asked;
    std::string reached;        ///< empty if the run says nothing about it
    std::optional<bool> met{};  ///< likewise none
};

/// In the order of the page. Of the presets that the run has.
std::vector<Target> targets(const Report& report, const std::vector<TortureScene>& torture);

/// As a table in Markdown.
std::string targets_table(const std::vector<Target>& targets);

}  // namespace bench
