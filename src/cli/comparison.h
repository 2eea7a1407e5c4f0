// SPDX-License-Identifier: MIT
// How wrong a picture is, as text and as JSON (`compare`).
#pragma once

#include <optional>
#include <string>

#include "image/compare.h"
#include "oracle/metrics.h"

namespace cli {

struct Comparison {
    oracle::Metrics metrics;
    bool heuristic = false;    ///< the reference rests on distance estimates
    bool has_normals = false;  ///< were compared
    std::optional<image::Difference> picture;
};

/// For people: a few aligned lines.
std::string comparison_text(const Comparison& comparison);

/// One JSON object, indented, with a newline at the end.
std::string comparison_json(const Comparison& comparison);

}  // namespace cli
