// SPDX-License-Identifier: MIT
// The operators in double precision on the GPU: GLSL has few of them, the others are our own.
#include <gtest/gtest.h>

#include <cmath>

#include <fmt/format.h>

#include "contract/arguments.h"
#include "contract/glsl_values.h"
#include "contract/operator_table.h"
#include "eval/operators.h"
#include "headless.h"

namespace contract {
namespace {

using graph::Op;

constexpr unsigned seed = 20261122;
constexpr std::size_t random_places = 1U << 13;

/// What is promised, in units of the operator's row: some units in the last place of a double.
double promised(Op op) {
    switch (op) {
        case Op::add:
        case Op::sub:
        case Op::mul:
        case Op::abs:
        case Op::neg:
            return 2.3e-16;
        default:
            return 4e-15;
    }
}

std::vector<Op> all_operators() {
    std::vector<Op> list;
    graph::for_each_operator([&](Op op) { list.push_back(op); });
    return list;
}

class Doubles : public testing::TestWithParam<Op> {};

TEST_P(Doubles, are_as_exact_as_promised) {
    const Op op = GetParam();
    const Row& row = *analysis::accuracy_of(op);
    const auto context = open_headless();
    ASSERT_TRUE(context) << context.problems()[0].message;
    Random random(seed);
    std::vector<Arguments> places = random_arguments(row, random_places, random);
    std::erase_if(places, [&](const Arguments& a) { return !is_promised(row, a); });
    const auto found =
        glsl_values(**context, operator_program(op, shader::Precision::doubled), places);
    ASSERT_EQ(found.size(), places.size());
    double worst = 0;
    int compared = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Arguments& a = places[i];
        const double expected = eval::apply<double>(op, a[0], a[1], a[2], a[3]);
        const double value = double(found[i][0]) + found[i][1] + found[i][2];
        // What a float cannot hold does not come back.
        const bool fits = std::isnan(expected) || expected == 0 ||
                          (std::abs(expected) < 1e38 && std::abs(expected) > 1e-20);
        if (!fits) continue;
        ++compared;
        if (std::isnan(expected) || std::isnan(value)) {
            EXPECT_EQ(std::isnan(expected), std::isnan(value))
                << graph::facts(op).name << " " << a[0];
            continue;
        }
        const double size = analysis::size_of(row.unit, a[1], expected);
        const double error = std::abs(value - expected) / (size > 0 ? size : 1);
        worst = std::max(worst, error);
        ASSERT_LE(error, promised(op))
            << fmt::format("{}({:.9g}, {:.9g}, {:.9g}) = {:.17g}, in GLSL {:.17g}, seed {}",
                           graph::facts(op).name, a[0], a[1], a[2], expected, value, seed);
    }
    EXPECT_GT(compared, static_cast<int>(random_places) / 16);
    fmt::print("worst error of {} in double precision: {:.2g} {}\n", graph::facts(op).name, worst,
               name_of(row.unit));
}

INSTANTIATE_TEST_SUITE_P(All, Doubles, testing::ValuesIn(all_operators()), [](const auto& info) {
    return std::string(graph::facts(info.param).name);
});

}  // namespace
}  // namespace contract
