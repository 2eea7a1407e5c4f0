// SPDX-License-Identifier: MIT
// A report as a file, to be read again.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "bench/report.h"

namespace bench {

/// One JSON object with everything that the report holds, and a newline at the end.
std::string report_json(const Report& report);

/// Reads it. Error: the text is no such report, or one of another version; `name` is named.
base::Result<Report> read_report(std::string_view text, const std::string& name);

}  // namespace bench
