// SPDX-License-Identifier: MIT
// All passes over random expressions: the same value within the running error bound, undefined at
// the same places, and never more to compute.
#include <gtest/gtest.h>

#include <rapidcheck.h>

#include <cmath>

#include "eval/random_expression.h"
#include "eval/tape.h"
#include "eval/wide.h"
#include "graph/print.h"
#include "passes/operation_count.h"
#include "passes/pipeline.h"
#include "property.h"

namespace passes {
namespace {

using eval::Extended;
using numeric::Interval;

constexpr int points_each = 100;

/// What is asked of an expression at one point.
struct Answer {
    double value = 0;
    Interval bound;      ///< holds the exact value; its width is a running error bound
    Extended reference;  ///< in 64 bits
    bool overflows = false;
};

class Asked {
public:
    Asked(const graph::Graph& graph, graph::NodeId root)
        : graph_(graph), root_(root), tape_(eval::make_tape(graph, std::array{root})) {}

    Answer at(const std::array<double, 4>& p) {
        const std::array<double, 3> point{p[0], p[1], p[2]};
        const std::array<Interval, 3> box{p[0], p[1], p[2]};
        Answer answer;
        eval::evaluate<double>(tape_, point, std::array{0.0, p[3]}, std::span(&answer.value, 1),
                               numbers_);
        eval::evaluate<Interval>(tape_, box, std::array<Interval, 2>{0.0, p[3]},
                                 std::span(&answer.bound, 1), intervals_);
        const std::array<Extended, 3> wide{p[0], p[1], p[2]};
        const auto all = eval::values_by_type<Extended>(
            graph_, root_, wide, std::array<Extended, 2>{Extended(0.0), Extended(p[3])});
        answer.reference = all.back();
        for (const Extended& number : all) {
            const auto value = static_cast<double>(number);
            // Far from both ends of double, so that regrouping reaches neither.
            answer.overflows = answer.overflows || std::abs(value) > 1e100 ||
                               (value != 0 && std::abs(value) < 1e-100);
        }
        return answer;
    }

private:
    const graph::Graph& graph_;
    graph::NodeId root_;
    eval::Tape tape_;
    std::vector<double> numbers_;
    std::vector<Interval> intervals_;
};

bool is_continuous(const Interval& a) {
    return !a.is_empty() && !a.partial && !a.jumps && std::isfinite(a.lo) && std::isfinite(a.hi);
}

TEST(PipelineProperty, keeps_value_and_domain_at_a_million_points_and_never_costs_more) {
    long checked = 0, compared = 0, undefined = 0;
    expect_property(20261122, 10000, 100, [&] {
        eval::Random random(*rc::gen::arbitrary<std::uint64_t>());
        auto [graph, root] = eval::random_expression(random, 1 + static_cast<int>(random() % 14));
        const std::vector<graph::NodeId> middle = run(graph, std::array{root});
        const graph::NodeId after = run(graph, middle, Stage::evaluation)[0];
        const std::string text =
            print(graph, std::array{root}) + "became\n" + print(graph, std::array{after});
        RC_ASSERT(count_operations(graph, std::array{after}).multiplied_out <=
                  count_operations(graph, std::array{root}).multiplied_out);
        Asked first(graph, root), last(graph, after);
        for (int i = 0; i < points_each; ++i) {
            const std::array p{eval::ordinary_number(random), eval::ordinary_number(random),
                               eval::ordinary_number(random), eval::ordinary_number(random)};
            const Answer a = first.at(p), b = last.at(p);
            ++checked;
            if (a.overflows || b.overflows) continue;
            // Nowhere defined before and after, or perhaps at the very edge of a domain.
            if (a.bound.is_empty()) {
                ++undefined;
                if (!b.bound.is_empty() && !b.bound.partial) RC_FAIL("became defined: " + text);
            }
            if (b.bound.is_empty() && !a.bound.is_empty() && !a.bound.partial) {
                RC_FAIL("became undefined: " + text);
            }
            if (!is_continuous(a.bound) || !is_continuous(b.bound)) continue;
            ++compared;
            const double bound = (a.bound.hi - a.bound.lo) + (b.bound.hi - b.bound.lo);
            const double exact = static_cast<double>(a.reference);
            const double ulp = std::nextafter(std::abs(exact), INFINITY) - std::abs(exact);
            if (!(std::abs(b.value - exact) <= bound + ulp)) RC_FAIL("lost its value: " + text);
        }
    });
    EXPECT_EQ(checked, 1000000);
    EXPECT_GT(compared, 300000) << "else the test says little";
    EXPECT_GT(undefined, 10000);
}

}  // namespace
}  // namespace passes
