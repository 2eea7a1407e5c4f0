// SPDX-License-Identifier: MIT
// Polynomials of one variable with real coefficients, and their roots.
#pragma once

#include <vector>

namespace render_answers {

/// The sum of coefficients[k] * t^k.
struct Polynomial {
    std::vector<double> coefficients;

    Polynomial(double constant) : coefficients{constant} {}
    explicit Polynomial(std::vector<double> list) : coefficients(std::move(list)) {}

    double at(double t) const;
    Polynomial derivative() const;
};
Polynomial operator+(const Polynomial& a, const Polynomial& b);
Polynomial operator-(const Polynomial& a, const Polynomial& b);
Polynomial operator*(const Polynomial& a, const Polynomial& b);

/// The places in [low, high] where the polynomial changes its sign, ascending, to double accuracy.
/// Roots without a change of sign are left out.
std::vector<double> sign_changes(const Polynomial& polynomial, double low, double high);

}  // namespace render_answers
