// SPDX-License-Identifier: MIT
#include "passes/horner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "passes/addition_chain.h"
#include "passes/live_nodes.h"
#include "passes/order_operands.h"
#include "passes/power_of.h"
#include "passes/rate.h"
#include "passes/signed_term.h"
#include "passes/tree.h"

namespace passes {
namespace {

using graph::Graph;
using graph::Node;
using graph::NodeId;
using graph::Op;

/// Longer sums are taken in groups, since the search takes the square of the number of terms.
constexpr std::size_t most_terms = 64;

/// A number times powers of different bases.
struct Monomial {
    double coefficient = 1;
    std::vector<PowerOf> factors;

    PowerOf* find(NodeId base) {
        const auto found = std::ranges::find(factors, base, &PowerOf::base);
        return found == factors.end() ? nullptr : &*found;
    }
    void multiply(const PowerOf& power) {
        PowerOf* known = find(power.base);
        if (known && known->exponent + power.exponent <= largest_chained_exponent) {
            known->exponent += power.exponent;
        } else {
            factors.push_back(power);
        }
    }
    void divide(const PowerOf& power) {
        PowerOf* known = find(power.base);
        known->exponent -= power.exponent;
        if (known->exponent == 0) factors.erase(factors.begin() + (known - factors.data()));
    }
};

class Factoring {
public:
    Factoring(Graph& graph, std::span<const NodeId> roots)
        : graph_(graph), rates_(graph), powers_(graph), live_(graph, roots) {
        const Usage usage = passes::usage(graph, roots);
        sums_ = inner_nodes(graph, usage, std::array{Op::add, Op::sub});
        products_ = inner_nodes(graph, usage, std::array{Op::add, Op::sub, Op::mul, Op::neg});
        for (const NodeId id : usage.order) {
            const bool is_sum = graph[id].op == Op::add || graph[id].op == Op::sub;
            if (!is_sum || sums_[index(id)] || !live_.has(id)) continue;
            const std::vector<Monomial> terms = terms_of(id);
            if (!has_common_factor(terms)) continue;
            live_.replace_if_cheaper(id, value_of(graph_, factored_in_groups(terms)));
        }
    }
    std::vector<NodeId> result(std::span<const NodeId> roots) { return live_.replaced(roots); }

private:
    std::vector<Monomial> terms_of(NodeId root) {
        std::vector<Monomial> terms;
        std::vector<SignedTerm> open{{root, false}};
        while (!open.empty()) {
            const SignedTerm term = open.back();
            open.pop_back();
            if (term.id != root && !sums_[index(term.id)]) {
                terms.push_back(monomial(term));
                continue;
            }
            const Node& node = graph_[term.id];
            open.push_back({node.arguments[1], term.negative != (node.op == Op::sub)});
            open.push_back({node.arguments[0], term.negative});
        }
        return terms;
    }

    Monomial monomial(const SignedTerm& term) {
        Monomial result;
        if (term.negative) result.coefficient = -1;
        std::vector<NodeId> open{term.id};
        while (!open.empty()) {
            const NodeId id = open.back();
            open.pop_back();
            const Node& node = graph_[id];
            const PowerOf power = powers_[id];
            const bool inner = products_[index(id)] && (node.op == Op::mul || node.op == Op::neg);
            if (graph_.is_constant(id) && std::isnormal(result.coefficient * node.value)) {
                result.coefficient *= node.value;
            } else if (power.exponent > 1 || !inner) {
                result.multiply(power);
            } else {
                if (node.op == Op::neg) result.coefficient = -result.coefficient;
                open.insert(open.end(), node.args().begin(), node.args().end());
            }
        }
        return result;
    }

    /// The base that most terms have, the first of equals; with how many.
    static std::pair<NodeId, std::size_t> commonest(const std::vector<Monomial>& terms) {
        std::map<NodeId, std::size_t> count;
        for (const Monomial& term : terms) {
            for (const PowerOf& factor : term.factors) ++count[factor.base];
        }
        std::pair<NodeId, std::size_t> best{{}, 0};
        for (const auto& [base, n] : count) {
            if (n > best.second) best = {base, n};
        }
        return best;
    }
    /// The same for the sizes of coefficients other than 1.
    static std::pair<double, std::size_t> commonest_size(const std::vector<Monomial>& terms) {
        std::map<double, std::size_t> count;
        for (const Monomial& term : terms) {
            const double size = std::abs(term.coefficient);
            if (size != 1 && !term.factors.empty()) ++count[size];
        }
        std::pair<double, std::size_t> best{1, 0};
        for (const auto& [size, n] : count) {
            if (n > best.second) best = {size, n};
        }
        return best;
    }
    static bool has_common_factor(const std::vector<Monomial>& terms) {
        return commonest(terms).second > 1 || commonest_size(terms).second > 1;
    }

    SignedTerm factored_in_groups(std::span<const Monomial> terms) {
        std::optional<SignedTerm> result;
        while (!terms.empty()) {
            const auto group = terms.first(std::min(terms.size(), most_terms));
            terms = terms.subspan(group.size());
            const SignedTerm part = factored({group.begin(), group.end()});
            result = result ? sum(graph_, *result, part) : part;
        }
        return *result;
    }

    SignedTerm factored(std::vector<Monomial> terms) {
        if (terms.size() == 1) return product(terms[0]);
        const auto [base, with_base] = commonest(terms);
        const auto [size, with_size] = commonest_size(terms);
        std::vector<Monomial> with, without;
        Monomial factor;
        if (with_base > 1 && with_base >= with_size) {
            int least = largest_chained_exponent;
            for (Monomial& term : terms) {
                const PowerOf* power = term.find(base);
                if (power) least = std::min(least, power->exponent);
                (power ? with : without).push_back(std::move(term));
            }
            factor.factors = {{base, least}};
            for (Monomial& term : with) term.divide(factor.factors[0]);
        } else if (with_size > 1) {
            factor.coefficient = size;
            for (Monomial& term : terms) {
                const bool fits = std::abs(term.coefficient) == size && !term.factors.empty();
                if (fits) term.coefficient /= size;
                (fits ? with : without).push_back(std::move(term));
            }
        } else {
            return plain_sum(terms);
        }
        const SignedTerm inner = factored(std::move(with));
        const SignedTerm outer{graph_.apply(Op::mul, product(factor).id, inner.id), inner.negative};
        return without.empty() ? outer : sum(graph_, outer, factored(std::move(without)));
    }

    SignedTerm plain_sum(const std::vector<Monomial>& terms) {
        SignedTerm result = product(terms[0]);
        for (std::size_t i = 1; i < terms.size(); ++i) {
            result = sum(graph_, result, product(terms[i]));
        }
        return result;
    }

    SignedTerm product(Monomial term) {
        const double size = std::abs(term.coefficient);
        std::ranges::sort(term.factors, [&](const PowerOf& a, const PowerOf& b) {
            const Rate left = rates_[a.base], right = rates_[b.base];
            return left != right ? left < right : stands_before(graph_, a.base, b.base);
        });
        std::optional<NodeId> result;
        if (size != 1 || term.factors.empty()) result = graph_.constant(size);
        for (const PowerOf& factor : term.factors) {
            const NodeId next = power(factor);
            result = result ? graph_.apply(Op::mul, *result, next) : next;
        }
        return {*result, term.coefficient < 0};
    }

    NodeId power(const PowerOf& power) {
        std::map<int, NodeId> known{{1, power.base}};
        for (const auto& [sum, a, b] : addition_chain(power.exponent)) {
            known[sum] = graph_.apply(Op::mul, known.at(a), known.at(b));
        }
        return known.at(power.exponent);
    }

    Graph& graph_;
    Rates rates_;
    Powers powers_;
    LiveNodes live_;
    std::vector<bool> sums_, products_;  ///< inner nodes
};

}  // namespace

std::vector<NodeId> horner(Graph& graph, std::span<const NodeId> roots) {
    return Factoring(graph, roots).result(roots);
}

}  // namespace passes
