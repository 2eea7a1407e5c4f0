// SPDX-License-Identifier: MIT
// Run time against error as a drawing.
#pragma once

#include <string>
#include <vector>

#include "bench/pareto.h"

namespace bench {

/// Trades of one tracer under one moving setting.
struct Curve {
    std::string name;    ///< of the tracer; curves of one name have one colour and one legend
    std::string moving;  ///< of the setting
    std::vector<Trade> trades;
    std::vector<std::string> labels;  ///< one a trade
};

/// One SVG element, without a document around it: both axes logarithmic, errors in parts of all
/// compared pixels. An error below `least_error` lies on the lowest line, which is marked 0. Each
/// curve is joined in its own order; trades on the Pareto front of all have a ring.
std::string svg_plot(const std::vector<Curve>& curves, double least_error);

/// Text with what HTML and SVG would take for markup replaced.
std::string escaped(std::string_view text);

}  // namespace bench
