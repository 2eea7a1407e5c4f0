// SPDX-License-Identifier: MIT
// Arithmetic of vectors, complex numbers, quaternions and triplex numbers, held against what is
// known of them.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <random>

#include "formula/understood.h"
#include "graph/substitute.h"

namespace formula {
namespace {

void check(std::string_view text, std::string_view errors) {
    EXPECT_EQ(errors_of(text), errors) << "formula: " << text;
}

constexpr unsigned seed = 20251122;

struct Random {
    std::mt19937 engine{seed};
    double operator()() { return std::uniform_real_distribution<double>(-2, 2)(engine); }
};

TEST(VectorArithmetic, adds_and_scales_by_components) {
    const std::string ab = "a = (1, 2, 3)\nb = (10, 20, 30)\n";
    EXPECT_EQ(value_of(ab + "(a + b).z"), 33);
    EXPECT_EQ(value_of(ab + "(a - b).x"), -9);
    EXPECT_EQ(value_of(ab + "(-a).y"), -2);
    EXPECT_EQ(value_of(ab + "(2a).y"), 4);
    EXPECT_EQ(value_of(ab + "(b*3).x"), 30);
    EXPECT_EQ(value_of(ab + "(b/10).z"), 3);
    EXPECT_EQ(value_of(ab + "a.x + 100b.yx.x + 3a.zzzz.w"), 1 + 2000 + 9);
    EXPECT_EQ(value_at("p = (x, y, z)\ndot(p, p)", {1, 2, 3}), 14);
}

TEST(VectorArithmetic, multiplies_complex_numbers) {
    Random random;
    for (int i = 0; i < 20; ++i) {
        const std::complex<double> a(random(), random()), b(random(), random());
        const auto value = [&](std::string_view expression) {
            const std::string text =
                fmt::format("a = complex({}, {})\nb = complex({}, {})\nc = {}\n", a.real(),
                            a.imag(), b.real(), b.imag(), expression);
            return std::complex<double>(value_of(text + "c.x + 0(a + b).x"),
                                        value_of(text + "c.y + 0(a + b).x"));
        };
        const auto expect = [&](std::string_view expression, std::complex<double> expected) {
            EXPECT_LT(std::abs(value(expression) - expected), 1e-12 * (1 + std::abs(expected)))
                << expression << " seed " << seed;
        };
        expect("a*b", a * b);
        expect("a/b", a / b);
        expect("2/b", 2.0 / b);
        expect("a^2", a * a);
        expect("a^7", std::pow(a, 7));
        expect("a^-3", std::pow(a, -3));
        expect("a^0", 1);
        expect("a^1", a);
        expect("a^2.5", std::pow(a, 2.5));
        expect("a + 3 - b", a + 3.0 - b);
        expect("3 - a", 3.0 - a);
        expect("a + (1, 2)", a + std::complex<double>(1, 2));
        expect("conj(a)", std::conj(a));
        expect("inverse(a)", 1.0 / a);
        expect("pow(a, 3)", a * a * a);
    }
}

TEST(VectorArithmetic, follows_hamiltons_rules) {
    const std::string units =
        "i = quaternion(0, 1, 0, 0)\nj = quaternion(0, 0, 1, 0)\nk = quaternion(0, 0, 0, 1)\n";
    const auto expect = [&](const std::string& product, const std::string& result) {
        EXPECT_EQ(value_of(units + "length(" + product + " - (" + result + ")) + 0(i + j + k).x"),
                  0)
            << product;
    };
    expect("i*j", "k");
    expect("j*k", "i");
    expect("k*i", "j");
    expect("j*i", "-k");
    expect("i*j*k", "quaternion(-1, 0, 0, 0)");
    expect("i^2", "quaternion(-1, 0, 0, 0)");
    expect("i^4 + 1", "quaternion(2, 0, 0, 0)");
    expect("i/j", "-k");
    expect("1/i", "-i");
}

TEST(VectorArithmetic, of_quaternions_has_lengths_that_multiply_and_inverses) {
    Random random;
    for (int i = 0; i < 20; ++i) {
        const std::string text = fmt::format(
            "p = quaternion({}, {}, {}, {})\nq = quaternion(({}, {}, {}, {}))\n", random(),
            random(), random(), random(), random(), random(), random(), random());
        const auto small = [&](const std::string& expression) {
            EXPECT_NEAR(value_of(text + expression + " + 0(p + q).x"), 0, 1e-9)
                << text << expression << " seed " << seed;
        };
        small("length(p*q) - length(p)length(q)");
        small("length(q*inverse(q) - quaternion(1, 0, 0, 0))");
        small("length(p/q*q - p)");
        small("length(conj(p*q) - conj(q)*conj(p))");
        small("length(q^2 - q*q)");
        small("length(q^3 - q*q*q)");
        small("length(q^7 - q*q*q*q*q*q*q)");
        small("length(q^-2 - inverse(q)*inverse(q))");
        small("length(q^0.5*q^0.5 - q)");
        small("length(q^0 - quaternion(1, 0, 0, 0))");
    }
}

TEST(VectorArithmetic, turns_like_a_quaternion) {
    Random random;
    for (int i = 0; i < 20; ++i) {
        const double degrees = 90 * random();
        const std::string text = fmt::format(
            "v = ({}, {}, {})\nn = normalize(({}, {}, {}))\nh = {}/360*pi\n"
            "s = sin(h)\nq = quaternion(cos(h), s*n.x, s*n.y, s*n.z)\n"
            "turned = q*quaternion(0, v.x, v.y, v.z)*conj(q)\n",
            random(), random(), random(), random(), random(), random(), degrees);
        EXPECT_NEAR(value_of(text + fmt::format("length(turned.yzw - turn(v, n, {}))", degrees)), 0,
                    1e-12)
            << text << " seed " << seed;
    }
}

TEST(VectorArithmetic, raises_triplex_numbers_alike_with_and_without_angles) {
    Random random;
    for (const int n : {1, 2, 3, 5, 8, 13, 32}) {
        const std::string text =
            fmt::format("param n = {}\np = triplex({}, {}, {})/2\nwhole = p^{}\nany = p^n\n", n,
                        random(), random(), random(), n);
        EXPECT_NEAR(value_of(text + "length(whole - any)/length(any)"), 0, 1e-12)
            << text << " seed " << seed;
        EXPECT_NEAR(value_of(text + "length(any) - length(p)^n + 0length(whole)"), 0, 1e-9);
    }
}

TEST(VectorArithmetic, of_types_that_do_not_fit_is_an_error) {
    check("(1, 2) + 3",
          "1:1: a vector of 2 and a number cannot be added; write a vector for the number too");
    check("3 - (1, 2)",
          "1:1: a number and a vector of 2 cannot be subtracted; write a vector for "
          "the number too");
    check("(1, 2) - (1, 2, 3)",
          "1:1: a vector of 2 and a vector of 3 cannot be subtracted; both "
          "need the same number of components");
    check("complex(1, 2) + quaternion(1, 2, 3, 4)",
          "1:1: a complex number and a quaternion cannot be added; both need the same number of "
          "components");
    check("1 + x*(1, 2)(3, 4)",
          "1:5: a vector of 2 and a vector of 2 cannot be multiplied; write "
          "dot(a, b), or multiply the components");
    check("(1, 2, 3)(x, y, z)",
          "1:1: a vector of 3 and a vector of 3 cannot be multiplied; write "
          "dot(a, b) or cross(a, b), or multiply the components");
    check("complex(1, 2)*(3, 4)",
          "1:1: a complex number and a vector of 2 cannot be multiplied; "
          "write complex(…) around the vector");
    check("(1, 2, 3)*quaternion(1, 2, 3, 4)",
          "1:1: a vector of 3 and a quaternion cannot be multiplied; make both of one kind");
    check("triplex(1, 2, 3)*triplex(1, 2, 3)",
          "1:1: a triplex number and a triplex number cannot be multiplied; triplex numbers have "
          "powers z^n only");
    check("(1, 2)/(3, 4)",
          "1:1: a vector of 2 cannot be divided by a vector of 2; divide by a "
          "number, or the components");
    check(
        "1/(3, 4)",
        "1:1: a number cannot be divided by a vector of 2; divide by a number, or the components");
    check("(1, 2)^2",
          "1:1: a vector of 2 has no powers; write dot(v, v) for the square of its "
          "length, or complex(v)^n");
    check("(x, y, z)^2",
          "1:1: a vector of 3 has no powers; write dot(v, v) for the square of its "
          "length, or triplex(v)^n");
    check("(x, y, z, 1)^2",
          "1:1: a vector of 4 has no powers; write dot(v, v) for the square of "
          "its length, or quaternion(v)^n");
    check("2^(1, 2)", "1:1: an exponent is a number, not a vector of 2");
    check("c = complex(1, 2)\nc^c", "2:1: an exponent is a number, not a complex number");
    check("-sphere(1)",
          "1:2: a field cannot be used in arithmetic; join fields with '|', '&' or '\\'");
}

TEST(VectorArithmetic, of_components_that_are_not_there_is_an_error) {
    check("p = (1, 2)\np.z", "2:3: a vector of 2 has no component 'z'; its components are x, y");
    check("p = complex(1, 2)\np.xw",
          "2:3: a complex number has no component 'w'; its components are x, y");
    check("a = 2\na.x", "2:3: a number has no components; '.x' needs a vector");
    check("sphere(1).x", "1:11: a field has no components; '.x' needs a vector");
    check("sin.x", "1:1: 'sin' needs its arguments in brackets; it is called 'sin(a)'");
    check("foo.x", "1:1: unknown name 'foo'");
}

}  // namespace
}  // namespace formula
