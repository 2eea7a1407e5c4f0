// SPDX-License-Identifier: MIT
#include "field/fractals.h"

#include <cmath>
#include <utility>

#include "graph/build.h"

namespace field {
namespace {

using graph::Expr;
using graph::NodeId;

/// Large enough for the estimate to be good, small enough to stop early.
constexpr double escape_radius = 4;

/// Collects the state of an iteration, variable by variable.
struct Builder {
    Field& field;
    Iteration iteration;

    Expr state(std::string name, Expr start) {
        const graph::VariableId id = field.graph.new_variable(std::move(name));
        iteration.state.push_back(id);
        iteration.start.push_back(start.id);
        return {field.graph, field.graph.variable(id)};
    }
    Expr point(graph::VariableId id) { return {field.graph, field.graph.variable(id)}; }
    Expr number(double value) { return {field.graph, value}; }
    Expr node(NodeId id) { return {field.graph, id}; }

    FieldId finish(std::initializer_list<Expr> step, Expr limit, std::optional<Expr> escape,
                   Expr distance) {
        for (Expr next : step) iteration.step.push_back(next.id);
        iteration.limit = limit.id;
        if (escape) iteration.escape = escape->id;
        iteration.distance = distance.id;
        return field.add(std::move(iteration));
    }
};

/// The potential of the boundary |z_N| = escape radius, seen from the start: log(B) / growth^N.
Expr boundary_potential(Expr growth, Expr limit) {
    return std::log(escape_radius) * pow(growth, -limit);
}

struct Complex {
    Expr re, im;
};

Complex operator*(Complex a, Complex b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

Complex whole_power(Complex base, int n) {
    if (n == 1) return base;
    const Complex half = whole_power(base, n / 2);
    const Complex square{half.re * half.re - half.im * half.im, 2.0 * half.re * half.im};
    return n % 2 == 0 ? square : square * base;
}

struct Triplex {
    Expr x, y, z;
};

/// p^n in spherical coordinates: radius to the power n, both angles times n.
Triplex triplex_power(Builder& b, Triplex p, Expr r, NodeId power) {
    const graph::Node node = b.field.graph[power];  // a copy: adding nodes moves them
    if (node.op == graph::Op::constant && node.value == std::floor(node.value) && node.value >= 2 &&
        node.value <= 32) {
        const int n = static_cast<int>(node.value);
        const Expr rho = hypot(p.x, p.y);
        const Complex polar = whole_power({p.z, rho}, n);
        const Complex around = whole_power({ratio(p.x, rho), ratio(p.y, rho)}, n);
        return {polar.im * around.re, polar.im * around.im, polar.re};
    }
    const Expr n = b.node(power);
    const Expr theta = n * acos(ratio(p.z, r));
    const Expr phi = n * atan2(p.y, p.x);
    const Expr radius = pow(r, n);
    return {radius * sin(theta) * cos(phi), radius * sin(theta) * sin(phi), radius * cos(theta)};
}

}  // namespace

FieldId julia(Field& field, std::span<const NodeId> arguments) {
    Builder b{field, {}};
    const Expr limit = b.node(arguments[4]);
    const Expr qa = b.state("qa", b.point(graph::variable_x));
    const Expr qb = b.state("qb", b.point(graph::variable_y));
    const Expr qc = b.state("qc", b.point(graph::variable_z));
    const Expr qd = b.state("qd", b.node(arguments[5]));
    const Expr growth = b.state("growth", b.number(1));  // |q'|
    const Expr potential = b.state("potential", boundary_potential(b.number(2), limit));
    const Expr imaginary = qb * qb + qc * qc + qd * qd;
    const Expr square = qa * qa + imaginary;
    const Expr length = sqrt(square);
    const Expr twice = 2.0 * qa;
    return b.finish({qa * qa - imaginary + b.node(arguments[0]), twice * qb + b.node(arguments[1]),
                     twice * qc + b.node(arguments[2]), twice * qd + b.node(arguments[3]),
                     2.0 * length * growth, 2.0 * potential},
                    limit, square - escape_radius * escape_radius,
                    0.5 * length * (0.5 * log(square) - potential) / growth);
}

FieldId mandelbulb(Field& field, std::span<const NodeId> arguments) {
    Builder b{field, {}};
    const Expr power = b.node(arguments[0]), limit = b.node(arguments[1]);
    const Expr px = b.point(graph::variable_x);
    const Expr py = b.point(graph::variable_y);
    const Expr pz = b.point(graph::variable_z);
    const Expr x = b.state("bx", px);
    const Expr y = b.state("by", py);
    const Expr z = b.state("bz", pz);
    const Expr growth = b.state("growth", b.number(1));  // |z'|
    const Expr potential = b.state("potential", boundary_potential(power, limit));
    const Expr r = hypot(x, y, z);
    const Triplex next = triplex_power(b, {x, y, z}, r, power.id);
    return b.finish({next.x + px, next.y + py, next.z + pz,
                     power * pow(r, power - 1.0) * growth + 1.0, power * potential},
                    limit, r - escape_radius, 0.5 * r * (log(r) - potential) / growth);
}

FieldId menger(Field& field, std::span<const NodeId> arguments) {
    Builder b{field, {}};
    const Expr x = b.point(graph::variable_x);
    const Expr y = b.point(graph::variable_y);
    const Expr z = b.point(graph::variable_z);
    const Expr qx = abs(x) - 1.0, qy = abs(y) - 1.0, qz = abs(z) - 1.0;
    const Expr cube =
        min(max(qx, max(qy, qz)), 0.0) + hypot(max(qx, 0.0), max(qy, 0.0), max(qz, 0.0));
    const Expr distance = b.state("distance", cube);
    const Expr scale = b.state("scale", b.number(1));
    // In each coordinate how far from the cell's middle third, in thirds: above 1 in the middle.
    const auto thirds = [&](Expr coordinate) {
        const Expr scaled = coordinate * scale;
        const Expr cell = scaled - 2.0 * floor(scaled * 0.5) - 1.0;
        return abs(1.0 - 3.0 * abs(cell));
    };
    const Expr tx = thirds(x), ty = thirds(y), tz = thirds(z);
    // A hole is where two of the three are in the middle: where the median is above 1.
    const Expr median = min(max(tx, ty), min(max(ty, tz), max(tz, tx)));
    const Expr finer = scale * 3.0;
    return b.finish({max(distance, (median - 1.0) / finer), finer}, b.node(arguments[0]),
                    std::nullopt, distance);
}

}  // namespace field
