// SPDX-License-Identifier: MIT
#include "render_answers/polynomial.h"

#include <algorithm>
#include <cmath>

namespace render_answers {

double Polynomial::at(double t) const {
    double value = 0;
    for (std::size_t k = coefficients.size(); k-- > 0;) value = value * t + coefficients[k];
    return value;
}

Polynomial Polynomial::derivative() const {
    std::vector<double> list;
    for (std::size_t k = 1; k < coefficients.size(); ++k) {
        list.push_back(static_cast<double>(k) * coefficients[k]);
    }
    return list.empty() ? Polynomial(0.0) : Polynomial(list);
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
    std::vector<double> list(std::max(a.coefficients.size(), b.coefficients.size()));
    for (std::size_t k = 0; k < a.coefficients.size(); ++k) list[k] += a.coefficients[k];
    for (std::size_t k = 0; k < b.coefficients.size(); ++k) list[k] += b.coefficients[k];
    return Polynomial(list);
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) { return a + b * -1.0; }

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    std::vector<double> list(a.coefficients.size() + b.coefficients.size() - 1);
    for (std::size_t i = 0; i < a.coefficients.size(); ++i) {
        for (std::size_t k = 0; k < b.coefficients.size(); ++k) {
            list[i + k] += a.coefficients[i] * b.coefficients[k];
        }
    }
    return Polynomial(list);
}

std::vector<double> sign_changes(const Polynomial& polynomial, double low, double high) {
    if (polynomial.coefficients.size() < 2) return {};
    if (polynomial.coefficients.size() == 2) {
        const double root = -polynomial.coefficients[0] / polynomial.coefficients[1];
        return low < root && root < high ? std::vector<double>{root} : std::vector<double>{};
    }
    // Between two neighbouring extrema the polynomial is monotonic.
    std::vector<double> ends{low};
    for (const double t : sign_changes(polynomial.derivative(), low, high)) ends.push_back(t);
    ends.push_back(high);
    std::vector<double> roots;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        double a = ends[k];
        double b = ends[k + 1];
        const bool above = polynomial.at(a) > 0;
        if (above == (polynomial.at(b) > 0)) continue;
        for (int round = 0; round < 200 && b - a > 1e-15 * std::abs(a + b); ++round) {
            const double middle = (a + b) / 2;
            ((polynomial.at(middle) > 0) == above ? a : b) = middle;
        }
        roots.push_back((a + b) / 2);
    }
    return roots;
}

}  // namespace render_answers
