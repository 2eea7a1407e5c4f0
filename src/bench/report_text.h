// SPDX-License-Identifier: MIT
// A report for people, as plain text.
#pragma once

#include <string>

#include "bench/report.h"

namespace bench {

/// One line for the machine and the run.
std::string machine_text(const Report& report);

/// A table of one preset: a line for each tracer and setting.
std::string preset_text(const PresetReport& preset);

}  // namespace bench
