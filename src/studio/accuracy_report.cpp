// SPDX-License-Identifier: MIT
#include "studio/accuracy_report.h"

#include <fmt/format.h>

namespace studio {
namespace {

std::string error_text(double error) { return error == 0 ? "0" : fmt::format("{:.2g}", error); }

ReportLine pixels(const char* word, std::size_t count, const char* help,
                  std::optional<oracle::Judgement> mark = std::nullopt) {
    return {word, fmt::format("{}", count), help, mark};
}

}  // namespace

std::vector<ReportLine> report_lines(const oracle::Metrics& metrics) {
    using oracle::Judgement;
    const oracle::Spread& depth = metrics.depth_error;
    return {
        pixels("compared", metrics.compared,
               "Pixels that are held against the reference: all but the undecided and the fragile "
               "ones."),
        pixels("missed", metrics.missed,
               "The ray meets the surface, but the picture shows none: a step was too long.",
               Judgement::missed),
        pixels("phantom", metrics.phantom,
               "The picture shows a surface where the ray meets none, for instance because it came "
               "closer than epsilon.",
               Judgement::phantom),
        pixels("moved", metrics.moved,
               "Both show a surface, but the depths differ by more than half of the pixel's "
               "footprint: often a sheet behind the first one.",
               Judgement::moved),
        pixels("unresolved", metrics.gave_up,
               "The tracer itself gave the ray up, at its limit of steps. What it shows there is "
               "judged as well."),
        pixels("undecided", metrics.undecided,
               "The reference could not settle these rays in double precision: even roots, tangent "
               "rays, poles, edges of the domain. Held against nobody.",
               Judgement::excused),
        pixels("fragile", metrics.fragile,
               "The reference itself answers otherwise within 0.03 pixel: too close to an outline "
               "to hold a tracer to it."),
        {"depth error, median", error_text(depth.median),
         "|t - t'| / t' of the depth t along the ray, where t' is the reference's: over the pixels "
         "where both show the surface and that are right.",
         std::nullopt},
        {"99 % below", error_text(depth.percentile_99),
         "99 of 100 of these pixels have at most this relative depth error.", std::nullopt},
        {"largest", error_text(depth.largest), "The largest relative depth error among them.",
         std::nullopt},
    };
}

ReportLine certainty(const oracle::Reference& reference) {
    if (reference.heuristic) {
        return {
            "heuristic", "",
            "An escape-time set is in the scene. Where it is not proven, the reference is the same "
            "finite iteration in double precision, stepped with a quarter of its distance "
            "estimate down to a thousandth of a pixel. That proves nothing.",
            std::nullopt};
    }
    return {"certified", "",
            "Every hit and every miss is proven by interval arithmetic in double precision; what "
            "could not be proven is undecided.",
            std::nullopt};
}

std::string verdict(const oracle::Metrics& metrics) {
    const std::size_t wrong = metrics.wrong();
    if (wrong == 0) return fmt::format("none of {} pixels is wrong", metrics.compared);
    const double share = 100 * static_cast<double>(wrong) / static_cast<double>(metrics.compared);
    return fmt::format("{} of {} pixels {} wrong ({:.2g} %)", wrong, metrics.compared,
                       wrong == 1 ? "is" : "are", share);
}

std::string report_text(const Accuracy& accuracy) {
    const Judged* judged = accuracy.judged();
    if (!judged) return {};
    std::string text = fmt::format(
        "{} x {}, reference {}, {:.1f} s\n{}\n{}\n", accuracy.reference->width,
        accuracy.reference->height, certainty(*accuracy.reference).word, accuracy.reference_seconds,
        describe(accuracy.measured[*accuracy.present].tracing), verdict(judged->metrics));
    for (const ReportLine& line : report_lines(judged->metrics)) {
        text += fmt::format("{}: {}\n", line.word, line.number);
    }
    for (const MeasuredSetting& setting : accuracy.measured) {
        const auto seconds = setting.frame_seconds();
        if (!setting.judged || !seconds) continue;
        text +=
            fmt::format("{}, steps {}, epsilon {:.4g}: {} wrong, {:.2f} ms\n",
                        describe(setting.tracing), setting.tracing.steps, setting.tracing.epsilon,
                        setting.judged->metrics.wrong(), 1000 * *seconds);
    }
    return text;
}

}  // namespace studio
