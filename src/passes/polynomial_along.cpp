// SPDX-License-Identifier: MIT
#include "passes/polynomial_along.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "graph/build.h"
#include "passes/operation_count.h"
#include "passes/pipeline.h"

namespace passes {
namespace {

using graph::Expr;
using graph::Graph;
using graph::Node;
using graph::NodeId;
using graph::Op;

/// A coefficient; empty is zero by structure, so that no product with 0 is ever built.
using Coefficient = std::optional<Expr>;

/// By rising powers, the last one not empty; without any it is zero.
using Polynomial = std::vector<Coefficient>;

Coefficient sum(const Coefficient& a, const Coefficient& b) {
    return a && b ? Coefficient(*a + *b) : (a ? a : b);
}

Coefficient product(const Coefficient& a, const Coefficient& b) {
    return a && b ? Coefficient(*a * *b) : std::nullopt;
}

Polynomial negative(Polynomial a) {
    for (Coefficient& it : a) {
        if (it) it = -*it;
    }
    return a;
}

Polynomial sum(const Polynomial& a, const Polynomial& b) {
    Polynomial result(std::max(a.size(), b.size()));
    for (std::size_t i = 0; i < result.size(); ++i) {
        result[i] = sum(i < a.size() ? a[i] : std::nullopt, i < b.size() ? b[i] : std::nullopt);
    }
    return result;
}

/// Two factors of every mixed product are equal: they are doubled first, which costs n additions.
Polynomial square(const Polynomial& a) {
    if (a.empty()) return {};
    Polynomial result(2 * a.size() - 1);
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Coefficient twice = sum(a[i], a[i]);
        result[2 * i] = sum(result[2 * i], product(a[i], a[i]));
        for (std::size_t j = i + 1; j < a.size(); ++j) {
            result[i + j] = sum(result[i + j], product(twice, a[j]));
        }
    }
    return result;
}

Polynomial product(const Polynomial& a, const Polynomial& b) {
    if (a.empty() || b.empty()) return {};
    Polynomial result(a.size() + b.size() - 1);
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) {
            result[i + j] = sum(result[i + j], product(a[i], b[j]));
        }
    }
    return result;
}

class Arithmetic {
public:
    Arithmetic(Graph& graph, const std::array<NodeId, 3>& p, const std::array<NodeId, 3>& d,
               std::size_t largest_degree)
        : graph_(graph), most_(largest_degree) {
        constexpr std::array point{graph::variable_x, graph::variable_y, graph::variable_z};
        for (std::size_t i = 0; i < 3; ++i) {
            of_[graph.variable(point[i])] = Polynomial{Expr(graph, p[i]), Expr(graph, d[i])};
        }
    }

    /// None if it is no polynomial.
    const std::optional<Polynomial>& of(NodeId root) {
        for (const NodeId id : reachable(graph_, std::array{root})) {
            if (!of_.contains(id)) of_[id] = find(id);
        }
        return of_.at(root);
    }

private:
    /// The arguments' are known.
    std::optional<Polynomial> find(NodeId id) {
        const Node node = graph_[id];
        std::vector<const Polynomial*> arguments;
        for (const NodeId argument : node.args()) {
            const std::optional<Polynomial>& it = of_.at(argument);
            if (!it) return std::nullopt;
            arguments.push_back(&*it);
        }
        if (graph_.is_constant(id, 0)) return Polynomial{};
        if (std::ranges::all_of(node.args(), [&](NodeId it) { return is_fixed(it); })) {
            fixed_.insert(id);
            return Polynomial{Expr(graph_, id)};
        }
        if (node.op == Op::neg) return negative(*arguments[0]);
        if (arguments.size() != 2) return std::nullopt;
        return of_two(node, *arguments[0], *arguments[1]);
    }

    std::optional<Polynomial> of_two(const Node& node, const Polynomial& a, const Polynomial& b) {
        const NodeId right = node.arguments[1];
        if (node.op == Op::add) return sum(a, b);
        if (node.op == Op::sub) return sum(a, negative(b));
        if (node.op == Op::mul && a.size() + b.size() > most_ + 2) return std::nullopt;
        if (node.op == Op::mul) return node.arguments[0] == right ? square(a) : product(a, b);
        if (node.op == Op::div && is_fixed(right)) {
            Polynomial result = a;
            for (Coefficient& it : result) {
                if (it) it = *it / Expr(graph_, right);
            }
            return result;
        }
        if (node.op == Op::pow && graph_.is_constant(right)) return power(a, graph_[right].value);
        return std::nullopt;
    }

    std::optional<Polynomial> power(const Polynomial& a, double exponent) const {
        const double most = static_cast<double>(most_);
        if (exponent < 1 || exponent > most || exponent != std::floor(exponent))
            return std::nullopt;
        if (a.empty()) return a;
        if (static_cast<double>(a.size() - 1) * exponent > most) return std::nullopt;
        Polynomial result = a;
        for (int i = 1; i < static_cast<int>(exponent); ++i) result = product(result, a);
        return result;
    }

    /// Whether it is the same everywhere along the ray.
    bool is_fixed(NodeId id) const { return fixed_.contains(id); }

    Graph& graph_;
    std::size_t most_;
    std::unordered_map<NodeId, std::optional<Polynomial>> of_{};
    std::unordered_set<NodeId> fixed_{};
};

/// Passed through the passes.
std::optional<std::vector<NodeId>> coefficients(Graph& graph, NodeId f, Arithmetic& arithmetic) {
    const std::optional<Polynomial>& found = arithmetic.of(f);
    if (!found) return std::nullopt;
    std::vector<NodeId> list;
    for (const Coefficient& it : *found) list.push_back(it ? it->id : graph.constant(0));
    list = run(graph, list);
    return run(graph, list, Stage::evaluation);
}

}  // namespace

std::optional<std::vector<NodeId>> polynomial_along(Graph& graph, NodeId f,
                                                    const std::array<NodeId, 3>& p,
                                                    const std::array<NodeId, 3>& d,
                                                    std::size_t largest_degree) {
    Arithmetic arithmetic(graph, p, d, largest_degree);
    const auto plain = coefficients(graph, f, arithmetic);
    if (!plain) return std::nullopt;
    // Where many monomials have common factors, fewer products are left with those out.
    const auto factored =
        coefficients(graph, run(graph, std::array{f}, Stage::evaluation)[0], arithmetic);
    const auto operations = [&](const std::vector<NodeId>& list) {
        return count_operations(graph, list).multiplied_out;
    };
    return factored && operations(*factored) < operations(*plain) ? factored : plain;
}

}  // namespace passes
