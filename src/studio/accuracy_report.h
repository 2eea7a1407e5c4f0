// SPDX-License-Identifier: MIT
// What is known about a view's accuracy, in words and numbers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oracle/metrics.h"
#include "studio/accuracy.h"

namespace studio {

/// One line of the panel.
struct ReportLine {
    std::string word, number;
    std::string help;
    std::optional<oracle::Judgement> mark;  ///< whose colour the overlay uses
};

/// Numbers of pixels, and relative errors of depths.
std::vector<ReportLine> report_lines(const oracle::Metrics& metrics);

/// What the reference rests on: a word, and what it means.
ReportLine certainty(const oracle::Reference& reference);

/// "12 of 28800 pixels are wrong (0.042 %)".
std::string verdict(const oracle::Metrics& metrics);

/// Everything about the present setting, and the table of measured settings, for the clipboard.
/// Empty if the view has not been judged.
std::string report_text(const Accuracy& accuracy);

}  // namespace studio
