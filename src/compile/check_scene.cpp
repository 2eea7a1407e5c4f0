// SPDX-License-Identifier: MIT
#include "compile/check_scene.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "analysis/dependence.h"
#include "analysis/extent.h"
#include "compile/visible_region.h"

namespace compile {
namespace {

/// Operators that a proof may evaluate in intervals: about half a millisecond.
constexpr std::size_t operations_a_proof = 20'000;

/// What looking at another expression costs beside its operators.
constexpr std::size_t overhead = 100;

analysis::Effort effort_for(const analysis::ContentFinder& content) {
    const std::size_t cells = operations_a_proof / std::max<std::size_t>(content.operations(), 1);
    return {.cells = static_cast<int>(std::clamp<std::size_t>(cells, 8, 1000)), .depth = 18};
}

std::string describe(const scene::Bounds& bounds) {
    const glm::dvec3 &c = bounds.centre, &h = bounds.half;
    const std::string place =
        c == glm::dvec3(0) ? "the origin" : fmt::format("({}, {}, {})", c.x, c.y, c.z);
    if (bounds.shape == scene::Bounds::Shape::sphere) {
        return fmt::format("the ball of radius {} about {}", h.x, place);
    }
    return fmt::format("the box of half extents ({}, {}, {}) about {}", h.x, h.y, h.z, place);
}

class Check {
public:
    Check(const Formula& formula, const scene::Document& document)
        : formula_(formula),
          bounds_(document.bounds),
          region_(visible_region(document.bounds)),
          values_(parameter_values(formula.field, document)),
          dependence_(analysis::dependence(formula.field, formula.field.root)),
          content_(formula.field, formula.field.root, values_) {}

    base::Diagnostics run() {
        if (!dependence_.on_point()) {
            return warn(
                "the formula does not depend on x, y or z, so that it holds everywhere or "
                "nowhere; use x, y or z");
        }
        const bool sheet = kind_of(formula_.field, formula_.field.root) == field::Kind::sheet;
        if (proven_empty_everywhere(content_)) {
            return warn(fmt::format("no point of space is {}; change the formula{}",
                                    sheet ? "on the surface" : "in the solid", or_parameters()));
        }
        if (bounds_.shape == scene::Bounds::Shape::none) return decided_comparisons();
        const analysis::Effort effort = effort_for(content_);
        if (proven_empty(content_, region_, effort)) {
            return warn(fmt::format("no part of the {} is in the bounds, {}; change the bounds{}",
                                    sheet ? "surface" : "solid", describe(bounds_),
                                    or_parameters()));
        }
        if (proven_full(content_, region_, effort)) {
            return warn(
                fmt::format("the solid fills the bounds, {}; widen the bounds, or cut "
                            "something out of it",
                            describe(bounds_)));
        }
        return decided_comparisons();
    }

private:
    /// Comparisons that are true everywhere in space or nowhere, whatever the parameters are.
    base::Diagnostics decided_comparisons() const {
        const field::Field& field = formula_.field;
        base::Diagnostics found;
        std::size_t operations = 0;
        std::vector<field::FieldId> objects = leaves(field, field.root);
        std::ranges::sort(objects);
        for (const auto& [id, span] : formula_.comparisons) {
            if (!std::ranges::binary_search(objects, id)) continue;
            if (analysis::dependence(field, id).on_parameters()) continue;
            analysis::ContentFinder content(field, id, values_);
            operations += overhead + content.operations();
            if (operations > operations_a_proof) break;
            const bool never = proven_empty_everywhere(content);
            if (!never && !proven_full_everywhere(content)) continue;
            found.push_back(base::warning(
                span, fmt::format("this comparison is true {}; change it, or take it away",
                                  never ? "nowhere" : "everywhere")));
        }
        return found;
    }

    base::Diagnostics warn(std::string message) const {
        return {base::warning(formula_.result, std::move(message))};
    }
    std::string_view or_parameters() const {
        return dependence_.on_parameters() ? " or the parameters" : "";
    }

    const Formula& formula_;
    const scene::Bounds& bounds_;
    analysis::Region region_;
    std::vector<double> values_;
    analysis::Dependence dependence_;
    analysis::ContentFinder content_;
};

}  // namespace

base::Diagnostics check_scene(const Formula& formula, const scene::Document& document) {
    return Check(formula, document).run();
}

}  // namespace compile
