// SPDX-License-Identifier: MIT
// The operators over intervals on the GPU: what the operator is in double precision anywhere in a
// box is enclosed. An operator that is new in graph/operators.def is tested without an edit here.
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "contract/arguments.h"
#include "contract/glsl_values.h"
#include "contract/operator_table.h"
#include "eval/operators.h"
#include "headless.h"
#include "shader/assembly.h"
#include "shader/interval_writer.h"

namespace contract {
namespace {

using graph::Op;
using limits = std::numeric_limits<float>;

constexpr unsigned seed = 20240317;
constexpr std::size_t boxes = 1U << 14;
constexpr int samples = 8;

/// Operands 1 and 3 of an operator are in [x, y] of a pixel's four numbers, 2 and 4 in [z, w].
std::string interval_program(Op op) {
    graph::Graph graph;
    const std::array<graph::VariableId, 2> variables{graph::variable_x, graph::variable_y};
    std::vector<graph::NodeId> arguments;
    for (std::size_t i = 0; i < static_cast<std::size_t>(graph::facts(op).arity); ++i) {
        arguments.push_back(graph.variable(variables[i % 2]));
    }
    const graph::NodeId root = graph.apply(op, arguments);
    const std::vector<bool> depends = depends_on_variables(graph);
    shader::FieldValues values;
    shader::IntervalWriter writer(graph, depends, values,
                                  {{graph::variable_x, "a.xy"}, {graph::variable_y, "a.zw"}});
    const std::string statements = writer.statements(root, "    ");
    shader::Assembly assembly;
    assembly.add_code("#version 450 core\n");
    assembly.add_part("common/real.glsl");
    assembly.add_code(
        "layout(std140, binding = 1) uniform Field { vec4 field_values[1024]; };\n"
        "layout(location = 1) out vec4 geometry_out;\n"
        "const bool zs_may_be_empty = true;\n");
    assembly.add_part("interval/interval.glsl");
    for (const std::string& part : writer.parts()) assembly.add_part(part);
    assembly.add_code(
        fmt::format("void main() {{\n"
                    "    ivec2 pixel = ivec2(gl_FragCoord.xy);\n"
                    "    vec4 a = field_values[pixel.y * 32 + pixel.x];\n"
                    "{}    geometry_out = vec4({}, zs_breaks ? 1.0 : 0.0, 0.0);\n"
                    "}}\n",
                    statements, writer.spelling(root)));
    return assembly.text();
}

/// From a number of the range on, of any width.
std::array<float, 2> random_interval(const Range& range, Random& random) {
    float a = random_number(range, random);
    if (std::isnan(a)) a = 1;
    if (random() % 4 == 0) return {a, a};
    float b = random_number(range, random);
    if (std::isnan(b)) b = 1;
    if (random() % 2 == 0) {
        const double width = std::exp2(std::uniform_real_distribution<double>(-24, 0)(random));
        b = static_cast<float>(a + width * std::max(std::abs(a), 1e-3F));
        b = std::clamp(b, static_cast<float>(range.low), static_cast<float>(range.high));
    }
    // An end may be infinite.
    const unsigned ends = random() % 16;
    return {ends == 0 ? -limits::infinity() : std::min(a, b),
            ends == 1 ? limits::infinity() : std::max(a, b)};
}

std::vector<Arguments> random_boxes(const Row& row, Random& random) {
    std::vector<Arguments> list(boxes);
    for (Arguments& box : list) {
        const auto first = random_interval(row.ranges[0], random);
        const bool two = graph::facts(row.op).arity > 1;
        const auto second = two ? random_interval(row.ranges[1], random) : first;
        box = {first[0], first[1], second[0], second[1]};
    }
    return list;
}

/// A number of the interval that is in the range.
float number_in(float low, float high, const Range& range, Random& random) {
    low = std::max(low, static_cast<float>(range.low));
    high = std::min(high, static_cast<float>(range.high));
    switch (random() % 4) {
        case 0:
            return low;
        case 1:
            return high;
        default:
            const double share = std::uniform_real_distribution<double>(0, 1)(random);
            return std::clamp(static_cast<float>(std::lerp(double{low}, double{high}, share)), low,
                              high);
    }
}

/// Empty is NaN; outside of the domain is told by the flag, and so is a pole, whose infinity has
/// the sign of a zero.
bool encloses(const std::array<float, 4>& found, double value) {
    if (std::isnan(value)) return found[2] != 0;
    if (std::isinf(value) && found[2] != 0) return true;
    if (std::isnan(found[0]) || std::isnan(found[1])) return false;
    return found[0] <= value && value <= found[1];
}

std::vector<Op> all_operators() {
    std::vector<Op> list;
    graph::for_each_operator([&](Op op) { list.push_back(op); });
    return list;
}

class IntervalsInGlsl : public testing::TestWithParam<Op> {};

TEST_P(IntervalsInGlsl, enclose_every_value) {
    const Op op = GetParam();
    const Row* row = analysis::accuracy_of(op);
    ASSERT_NE(row, nullptr);
    const auto context = open_headless();
    ASSERT_TRUE(context) << context.problems()[0].message;
    Random random(seed);
    const std::vector<Arguments> list = random_boxes(*row, random);
    const auto found = glsl_values(**context, interval_program(op), list);
    ASSERT_EQ(found.size(), list.size());
    int wrong = 0, narrow = 0, wide = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const Arguments& box = list[i];
        for (int k = 0; k < samples; ++k) {
            Arguments a{};
            for (std::size_t j = 0; j < a.size(); ++j) {
                const std::size_t pair = j % 2 == 0 ? 0 : 2;
                a[j] = number_in(box[pair], box[pair + 1], row->ranges[j], random);
            }
            if (!is_allowed(op, a)) continue;
            const double value = eval::apply<double>(op, a[0], a[1], a[2], a[3]);
            if (encloses(found[i], value)) continue;
            if (++wrong > 5) break;
            ADD_FAILURE() << fmt::format(
                "{}({}, {}, {}, {}) = {:.9g} is not in [{:.9g}, {:.9g}]{} of the box [{}, {}], "
                "[{}, "
                "{}] (seed {})",
                graph::facts(op).name, a[0], a[1], a[2], a[3], value, found[i][0], found[i][1],
                found[i][2] != 0 ? " with breaks" : "", box[0], box[1], box[2], box[3], seed);
        }
        // A single point, well inside of the domain, has a small interval.
        const bool point = box[0] == box[1] && box[2] == box[3] && found[i][2] == 0;
        // Powers of 0 jump with the exponent.
        if (op == Op::pow && box[0] == 0) continue;
        const bool moderate = std::max(std::abs(box[0]), std::abs(box[2])) < 8;
        if (!point || !moderate || !(std::abs(found[i][1]) < 1e6F)) continue;
        ++narrow;
        const double least = found[i][0];
        const bool is_wide = !(found[i][1] - least <= 1e-4 * (1 + least * least));
        wide += is_wide;
        if (is_wide && wide < 5) {
            ADD_FAILURE() << fmt::format("{}({}, {}) is in [{:.9g}, {:.9g}] only",
                                         graph::facts(op).name, box[0], box[2], least, found[i][1]);
        }
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(wide, 0) << "of " << narrow;
    EXPECT_GT(narrow, 50);
}

INSTANTIATE_TEST_SUITE_P(All, IntervalsInGlsl, testing::ValuesIn(all_operators()),
                         [](const auto& info) {
                             return std::string(graph::facts(info.param).name);
                         });

}  // namespace
}  // namespace contract
