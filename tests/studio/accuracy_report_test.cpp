// SPDX-License-Identifier: MIT
// Accuracy in words.
#include "studio/accuracy_report.h"

#include <gtest/gtest.h>

namespace {

using studio::Accuracy;

oracle::Metrics some_metrics() {
    oracle::Metrics metrics;
    metrics.compared = 1000;
    metrics.undecided = 3;
    metrics.fragile = 20;
    metrics.missed = 7;
    metrics.phantom = 2;
    metrics.moved = 1;
    metrics.gave_up = 4;
    metrics.depth_error = {1.234e-7, 5e-6, 0.001};
    return metrics;
}

TEST(AccuracyReport, says_how_many_pixels_are_wrong) {
    oracle::Metrics metrics = some_metrics();
    EXPECT_EQ(studio::verdict(metrics), "10 of 1000 pixels are wrong (1 %)");
    metrics.missed = metrics.phantom = 0;
    EXPECT_EQ(studio::verdict(metrics), "1 of 1000 pixels is wrong (0.1 %)");
    metrics.moved = 0;
    EXPECT_EQ(studio::verdict(metrics), "none of 1000 pixels is wrong");
}

TEST(AccuracyReport, has_a_line_with_help_for_every_number) {
    std::string text;
    for (const auto& line : studio::report_lines(some_metrics())) {
        EXPECT_FALSE(line.help.empty()) << line.word;
        text += line.word + " " + line.number + "\n";
    }
    EXPECT_EQ(text,
              "compared 1000\nmissed 7\nphantom 2\nmoved 1\nunresolved 4\nundecided 3\n"
              "fragile 20\ndepth error, median 1.2e-07\n99 % below 5e-06\nlargest 0.001\n");
}

TEST(AccuracyReport, tells_a_proof_from_a_guess) {
    EXPECT_EQ(studio::certainty({}).word, "certified");
    oracle::Reference fractal;
    fractal.heuristic = true;
    EXPECT_EQ(studio::certainty(fractal).word, "heuristic");
}

TEST(AccuracyReport, is_a_text_of_the_present_setting_and_of_all_that_were_measured) {
    Accuracy accuracy;
    EXPECT_EQ(studio::report_text(accuracy), "");
    oracle::Reference reference;
    reference.width = 40;
    reference.height = 25;
    accuracy.reference = std::make_shared<const oracle::Reference>(std::move(reference));
    accuracy.reference_seconds = 1.25;
    accuracy.of_this_view = true;
    const auto judged = std::make_shared<const studio::Judged>(studio::Judged{some_metrics(), {}});
    accuracy.measured = {{{"auto", 1, 64, 0.1}, judged, {0.004, 0.002, 0.003}},
                         {{"sphere", 0.5, 64, 0.1}, judged, {}}};
    accuracy.present = 0;
    EXPECT_EQ(studio::report_text(accuracy),
              "40 x 25, reference certified, 1.2 s\nauto, Lipschitz scale 1\n"
              "10 of 1000 pixels are wrong (1 %)\n"
              "compared: 1000\nmissed: 7\nphantom: 2\nmoved: 1\nunresolved: 4\nundecided: 3\n"
              "fragile: 20\ndepth error, median: 1.2e-07\n99 % below: 5e-06\nlargest: 0.001\n"
              "auto, Lipschitz scale 1, steps 64, epsilon 0.1: 10 wrong, 3.00 ms\n");
    accuracy.of_this_view = false;
    EXPECT_EQ(studio::report_text(accuracy), "");
}

}  // namespace
