// SPDX-License-Identifier: MIT
// Polynomials, which are followed by their coefficients along the ray, against known answers:
// degrees from 3 to 12, roots without a change of sign, walls close to each other, and trees of
// them.
#include <ostream>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "render_answers/agreement.h"
#include "render_answers/ray.h"

namespace render_answers {
namespace {

using P = Polynomial;

const scene::Bounds two = sphere_bounds(2);
const scene::Camera aside = camera({2.2, 1.6, 3.1});

P power(const P& base, int exponent) {
    P result = base;
    for (int i = 1; i < exponent; ++i) result = result * base;
    return result;
}

std::vector<Answer> answers() {
    std::vector<Answer> list;
    for (int n = 3; n <= 12; ++n) {
        list.push_back({fmt::format("graph_of_degree_{}", n),
                        {fmt::format("z = x^{} - y^2*x/2", n), two, aside},
                        zeros([n](const P& x, const P& y, const P& z) {
                            return power(x, n) - 0.5 * (y * y * x) - z;
                        })});
    }
    for (const int half : {2, 3, 5, 6}) {
        list.push_back({fmt::format("sphere_of_degree_{}", 2 * half),
                        {fmt::format("(x^2 + y^2 + z^2)^{} = 1", half), two, aside},
                        boundary(ball(1))});
    }
    const Sheet slope =
        zeros([](const P& x, const P&, const P& z) { return 0.6 * x + 0.8 * z - 0.25; });
    list.push_back({"plane_squared", {"(0.6x + 0.8z - 0.25)^2 = 0", two, aside}, slope});
    list.push_back({"plane_squared_times_a_sum_of_squares",
                    {"(0.6x + 0.8z - 0.25)^2 * (1 + x^2 + y^4) = 0", two, aside},
                    slope});
    list.push_back({"spheres_a_thousandth_apart",
                    {"(x^2 + y^2 + z^2 - 1)*(x^2 + y^2 + z^2 - 0.998) = 0", two, aside},
                    boundary(ball(1))});
    list.push_back({"shell_as_one_formula",
                    {"(x^2 + y^2 + z^2 - 1)*(x^2 + y^2 + z^2 - 0.998) <= 0", two, aside},
                    ball(1)});
    list.push_back({"difference_of_quartic_and_sphere",
                    {"(x^2 + y^2 + z^2 + 1 - 0.16)^2 <= 4(x^2 + y^2) \\ (x - 0.9)^2 + y^2 + z^2 "
                     "<= 0.36",
                     two, aside},
                    torus(1, 0.4) & !ball(0.6, {0.9, 0, 0})});
    list.push_back({"from_inside",
                    {"(x^2 + y^2 + z^2)^3 = 1", two, camera({0.1, 0.2, 0.3}, {1, 0, 0})},
                    boundary(ball(1))});
    return list;
}

class PolynomialAnswer : public testing::TestWithParam<Answer> {};

TEST_P(PolynomialAnswer, is_found) {
    Answer answer = GetParam();
    answer.query.width = 64;
    answer.query.height = 48;
    const Agreement agreement = compare(answer);
    EXPECT_EQ(agreement.wrong(), 0) << answer.query.formula << ": " << agreement;
    EXPECT_GT(agreement.compared, 1000);
}

INSTANTIATE_TEST_SUITE_P(Shapes, PolynomialAnswer, testing::ValuesIn(answers()),
                         [](const auto& info) { return info.param.name; });

/// A plane, but its formula has a triple root along a line, and no gradient there.
TEST(PolynomialNormal, is_right_beside_a_triple_root) {
    const glm::dvec3 expected = glm::normalize(glm::dvec3(0, 1, -0.5));
    for (const double beside : {1e-4, 2e-4, 5e-4, 2e-3}) {
        const render::Still still =
            render({.formula = "y^3 = z^3/8",
                    .bounds = two,
                    .camera = camera({0.3, 3.2, beside}, {0, 0, beside}, 45, {0, 0, 1}),
                    .width = 61,
                    .height = 45});
        for (int i = 0; i < 61; ++i) {
            if (status(still, i, 22) != shader::Status::hit) continue;
            EXPECT_LT(glm::distance(normal(still, i, 22), expected), 0.03)
                << beside << " beside the line, pixel " << i;
        }
        EXPECT_EQ(status(still, 30, 22), shader::Status::hit);
    }
}

}  // namespace
}  // namespace render_answers
