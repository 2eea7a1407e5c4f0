// SPDX-License-Identifier: MIT
// A report as one page for a browser.
#pragma once

#include <string>
#include <vector>

#include "bench/measure.h"
#include "bench/report.h"

namespace bench {

/// One HTML document that needs nothing from elsewhere, no script either: the machine, and of each
/// preset the plot of run time against error, the table, and pictures of where tracers are wrong.
/// `pictures` has a list for each preset of the report, or is empty.
std::string report_html(const Report& report,
                        const std::vector<std::vector<MarkedPicture>>& pictures);

}  // namespace bench
