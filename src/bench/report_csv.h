// SPDX-License-Identifier: MIT
// A report as a table for other programs.
#pragma once

#include <string>

#include "bench/report.h"

namespace bench {

/// Comma-separated: a line of names, then one for each preset, tracer and setting. Cells of what
/// was not measured are empty.
std::string report_csv(const Report& report);

}  // namespace bench
