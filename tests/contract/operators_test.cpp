// SPDX-License-Identifier: MIT
// One meaning for every operator: the evaluators for double, for intervals and on the GPU agree on
// values and on where there are none. An operator that is new in graph/operators.def is tested
// without an edit here and fails until the table says what is promised of it.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include <fmt/format.h>

#include "base/file.h"
#include "contract/arguments.h"
#include "contract/glsl_values.h"
#include "contract/operator_table.h"
#include "eval/operators.h"
#include "headless.h"

namespace contract {
namespace {

using graph::Op;
using limits = std::numeric_limits<float>;

constexpr unsigned seed = 20240311;
constexpr std::size_t random_places = 1U << 15;

std::vector<Op> all_operators() {
    std::vector<Op> list;
    graph::for_each_operator([&](Op op) { list.push_back(op); });
    return list;
}

double double_value(Op op, const Arguments& a) {
    return eval::apply<double>(op, a[0], a[1], a[2], a[3]);
}

std::string describe(Op op, const Arguments& a) {
    std::string text = fmt::format("{}(", graph::facts(op).name);
    for (int i = 0; i < graph::facts(op).arity; ++i) {
        text += fmt::format("{}{:.9g}", i == 0 ? "" : ", ", a[static_cast<std::size_t>(i)]);
    }
    return text + fmt::format(") = {:.17g}, seed {}", double_value(op, a), seed);
}

/// Machines may take denormal numbers for zeros.
Arguments without_denormals(Arguments a) {
    for (float& number : a) {
        if (std::fpclassify(number) == FP_SUBNORMAL) number = std::copysign(0.0F, number);
    }
    return a;
}

/// The error of a value on the GPU in the row's unit; infinite where it is of the wrong kind
/// (undefined, or infinite, or not). Where single precision overflows or underflows the nearest
/// infinity or zero is right, and near its end both are.
double error_of(const Row& row, const Arguments& a, double expected, float found) {
    const double wrong = std::numeric_limits<double>::infinity();
    if (std::isnan(expected)) return std::isnan(found) ? 0 : wrong;
    if (std::isnan(found)) return wrong;
    const float rounded = static_cast<float>(expected);
    if (std::isinf(rounded))
        return found == rounded || found == std::copysign(limits::max(), rounded) ? 0 : wrong;
    if (std::abs(expected) < limits::min())
        return std::abs(found) <= limits::min() || !is_promised(row, a) ? 0 : wrong;
    if (!is_promised(row, a)) return 0;
    if (std::abs(rounded) > 0.99F * limits::max() && std::isinf(found)) return 0;
    const double error = std::abs(found - expected);
    return error == 0 ? 0 : error / analysis::size_of(row.unit, a[1], expected);
}

/// As above, taking denormal arguments either way.
double error_of(const Row& row, const Arguments& a, float found) {
    const Arguments flushed = without_denormals(a);
    const double error = error_of(row, a, double_value(row.op, a), found);
    if (flushed == a) return error;
    return std::min(error, error_of(row, flushed, double_value(row.op, flushed), found));
}

/// A value at a point must be in the interval; none, or a pole's infinity, needs `partial`.
bool is_covered(const numeric::Interval& interval, double value) {
    if (std::isnan(value)) return interval.partial;
    if (std::isinf(value) && interval.partial) return true;
    return interval.contains(value);
}

numeric::Interval enclosure(Op op, const Arguments& a, bool widened) {
    std::array<numeric::Interval, graph::max_arity> box;
    for (std::size_t i = 0; i < box.size(); ++i) {
        box[i] = static_cast<double>(a[i]);
        if (widened && !std::isnan(a[i])) {
            box[i] = {std::nextafter(a[i], -limits::infinity()),
                      std::nextafter(a[i], limits::infinity())};
        }
    }
    return eval::apply<numeric::Interval>(op, box[0], box[1], box[2], box[3]);
}

/// All places where an operator is looked at.
std::vector<Arguments> places(const Row& row) {
    Random random(seed);
    std::vector<Arguments> list = awkward_arguments(graph::facts(row.op).arity, random);
    const auto more = random_arguments(row, random_places, random);
    list.insert(list.end(), more.begin(), more.end());
    std::erase_if(list, [&](const Arguments& a) { return !is_allowed(row.op, a); });
    return list;
}

class Operators : public testing::TestWithParam<Op> {
protected:
    void SetUp() override {
        row = analysis::accuracy_of(GetParam());
        ASSERT_NE(row, nullptr) << "operator_accuracy.cpp has no row for "
                                << graph::facts(GetParam()).name;
    }

    const Row* row = nullptr;
};

TEST_P(Operators, intervals_contain_the_value_in_double_precision) {
    for (const Arguments& a : places(*row)) {
        const double value = double_value(row->op, a);
        for (const bool widened : {false, true}) {
            const numeric::Interval interval = enclosure(row->op, a, widened);
            ASSERT_TRUE(is_covered(interval, value))
                << describe(row->op, a) << " is not in [" << interval.lo << ", " << interval.hi
                << (widened ? "] around neighbours" : "]");
        }
    }
}

TEST_P(Operators, glsl_is_as_exact_as_promised_and_undefined_at_the_same_places) {
    const auto context = open_headless();
    ASSERT_TRUE(context) << context.problems()[0].message;
    const std::vector<Arguments> list = places(*row);
    const auto found = glsl_values(**context, operator_program(row->op), list);
    ASSERT_EQ(found.size(), list.size());
    double worst = 0;
    int wrong = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const double error = error_of(*row, list[i], found[i][0]);
        worst = std::max(worst, error);
        if (error <= row->bound || ++wrong > 10) continue;
        ADD_FAILURE() << describe(row->op, list[i]) << " in GLSL is " << found[i][0] << ": error "
                      << error << " " << name_of(row->unit) << ", promised " << row->bound;
    }
    EXPECT_EQ(wrong, 0) << "of " << list.size() << " places";
    RecordProperty("worst_error", fmt::format("{:.2g}", worst));
    fmt::print("worst error of {}: {:.2g} {}\n", graph::facts(row->op).name, worst,
               name_of(row->unit));
}

INSTANTIATE_TEST_SUITE_P(All, Operators, testing::ValuesIn(all_operators()), [](const auto& info) {
    return std::string(graph::facts(info.param).name);
});

TEST(OperatorTable, has_one_row_for_each_operator) {
    const std::vector<Op> operators = all_operators();
    ASSERT_EQ(analysis::operator_accuracies().size(), operators.size());
    for (const Op op : operators)
        EXPECT_NE(analysis::accuracy_of(op), nullptr) << graph::facts(op).name;
}

/// The document's rows look like "| `sin` | arguments | unit | found | promised |".
TEST(OperatorTable, agrees_with_the_document) {
    const auto document =
        base::read_text(std::string(ZEROSET_SOURCE_DIR) + "/docs/numerics.md", 1 << 20);
    ASSERT_TRUE(document) << document.problems()[0].message;
    for (const Row& row : analysis::operator_accuracies()) {
        const std::size_t begin =
            document->find(fmt::format("\n| `{}` |", graph::facts(row.op).name));
        ASSERT_NE(begin, std::string::npos) << "no row for " << graph::facts(row.op).name;
        const std::string line =
            document->substr(begin + 1, document->find('\n', begin + 1) - begin - 1);
        const std::string end =
            row.unit == Unit::none ? "| 0 |" : fmt::format("| {:.1e} |", row.bound);
        EXPECT_TRUE(line.ends_with(end)) << line << "\nshould end in " << end;
    }
}

}  // namespace
}  // namespace contract
