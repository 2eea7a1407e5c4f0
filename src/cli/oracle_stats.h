// SPDX-License-Identifier: MIT
// The statistics of a reference as JSON (`oracle --stats`).
#pragma once

#include <string>

#include "oracle/reference.h"

namespace cli {

/// One JSON object, indented, with a newline at the end.
std::string oracle_stats_json(const oracle::Reference& reference, double seconds);

}  // namespace cli
