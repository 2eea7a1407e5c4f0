// SPDX-License-Identifier: MIT
#include "formula/complex.h"

namespace formula {
namespace {

using graph::Expr;

Complex squared(Complex a) { return {a.re * a.re - a.im * a.im, 2.0 * a.re * a.im}; }

Expr squared_length(Complex a) { return a.re * a.re + a.im * a.im; }

}  // namespace

Complex operator*(Complex a, Complex b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

Complex operator/(Complex a, Complex b) {
    const Complex product = a * Complex{b.re, -b.im};
    const Expr square = squared_length(b);
    return {product.re / square, product.im / square};
}

Complex inverse(Complex a) {
    const Expr square = squared_length(a);
    return {a.re / square, -a.im / square};
}

Complex whole_power(Complex a, int n) {
    if (n == 1) return a;
    const Complex square = squared(whole_power(a, n / 2));
    return n % 2 == 0 ? square : square * a;
}

Complex real_power(Complex a, Expr n) {
    const Expr length = pow(hypot(a.re, a.im), n);
    const Expr angle = n * atan2(a.im, a.re);
    return {length * cos(angle), length * sin(angle)};
}

}  // namespace formula
