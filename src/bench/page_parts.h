// SPDX-License-Identifier: MIT
// What the pages of a run have in common.
#pragma once

#include <string>
#include <vector>

#include "bench/report.h"

namespace bench {

/// Machine, size and command of a run, as a section in Markdown.
std::string run_description(const Report& report);

/// The tracers of a run in the order of their first entries, without what they are compared with.
std::vector<std::string> tracer_names(const Report& report);

}  // namespace bench
