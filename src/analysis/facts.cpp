// SPDX-License-Identifier: MIT
#include "analysis/facts.h"

#include <algorithm>
#include <array>
#include <map>
#include <ranges>

#include "analysis/derivative_bounds.h"
#include "analysis/polynomial_degree.h"
#include "field/parts.h"

namespace analysis {
namespace {

using field::FieldId;
using graph::NodeId;
using numeric::infinity;

constexpr Effort smoothness_effort{.cells = 400, .depth = 24};

/// Operators that one proof may evaluate in intervals: some milliseconds.
constexpr std::size_t operations_a_proof = 400'000;

Effort extent_effort(const ContentFinder& content) {
    const std::size_t cells = operations_a_proof / std::max<std::size_t>(content.operations(), 1);
    return {.cells = static_cast<int>(std::clamp<std::size_t>(cells, 100, 20'000)),
            .tolerance = 1.0 / 512};
}

class Finder {
public:
    Finder(const field::Field& field, const Region& region, std::span<const double> parameters)
        : field_(field), region_(region), parameters_(parameters) {}

    Facts find(FieldId id) {
        Facts facts;
        facts.kind = kind_of(field_, id);
        if (const auto* formula = std::get_if<field::Formula>(&field_[id])) {
            facts.degree = polynomial_degree(field_.graph, formula->value);
            facts.lipschitz = lipschitz(id);
        }
        facts.regularity = regularity_of(id);
        facts.metric = metric(field_, id, [&](FieldId leaf) { return lipschitz(leaf); });
        find_extent(id, facts);
        facts.dependence = dependence(field_, id);
        facts.cost = cost(field_, id);
        return facts;
    }

private:
    double lipschitz(FieldId leaf) {
        const auto found = lipschitz_.find(leaf);
        if (found != lipschitz_.end()) return found->second;
        const auto& formula = std::get<field::Formula>(field_[leaf]);
        const Regularity regular = regularity_of(leaf);
        // Across a jump or the edge of a domain the gradient says nothing.
        const bool breaks = regular.partial || regular.smoothness == Smoothness::discontinuous;
        const eval::Tape tape = eval::make_tape(field_.graph, std::array{formula.value});
        return lipschitz_[leaf] =
                   breaks ? infinity : gradient_bound(tape, region_, parameters_, {});
    }

    Regularity regularity_of(FieldId id) const {
        const auto of = [&](NodeId root) {
            return analysis::regularity(field_.graph, root, region_, parameters_,
                                        smoothness_effort);
        };
        if (const auto* formula = std::get_if<field::Formula>(&field_[id])) {
            return of(formula->value);
        }
        if (std::holds_alternative<field::Iteration>(field_[id])) {
            return of_iteration(std::get<field::Iteration>(field::shape(field_, id)), of);
        }
        // Across the walls of cells anything may happen.
        if (std::holds_alternative<field::Cells>(field_[id])) return {};
        return of_operation(id, of);
    }

    /// Values are joined with kinks; a choice is one of them.
    Regularity of_operation(FieldId id, const auto& of) const {
        const std::vector<FieldId> below = field::children(field_[id]);
        const bool chosen = std::holds_alternative<field::Choice>(field_[id]);
        const bool joined = below.size() > 1 && !chosen;
        Regularity worst{joined ? Smoothness::piecewise : Smoothness::smooth, false};
        if (!chosen) {
            for (const NodeId root : field::expressions(field_[id])) worst = worse(worst, of(root));
        }
        for (const FieldId child : below) worst = worse(worst, regularity_of(child));
        return worst;
    }

    static Regularity worse(const Regularity& a, const Regularity& b) {
        return {std::max(a.smoothness, b.smoothness), a.partial || b.partial};
    }

    /// A fixed number of turns is a composition; what escapes at some turn has an answer for each.
    static Regularity of_iteration(const field::Iteration& iteration, const auto& of) {
        Regularity worst{iteration.escape ? Smoothness::discontinuous : Smoothness::smooth, false};
        for (const NodeId root : iteration.start) worst = worse(worst, of(root));
        for (const NodeId root : iteration.step) worst = worse(worst, of(root));
        return worse(worst, of(iteration.distance));
    }

    void find_extent(FieldId id, Facts& facts) const {
        ContentFinder content(field_, id, parameters_);
        const Effort effort = extent_effort(content);
        if (proven_empty(content, region_, effort)) return;
        facts.full = proven_full(content, region_, effort);
        facts.box = bounding_box(content, region_, effort);
        if (facts.box) facts.reach = reach(content, region_, *facts.box, effort);
    }

    const field::Field& field_;
    const Region& region_;
    std::span<const double> parameters_;
    std::map<FieldId, double> lipschitz_;
};

/// For every object of the scene a node that is all that is seen of it: the object itself, or its
/// copies in the cells around it.
class Copies {
public:
    explicit Copies(field::Field& field) : field_(field) { walk(field.root); }

    std::vector<FieldId> found{};  ///< in the order of field::leaves

private:
    void walk(FieldId id) {
        const field::Node node = field_[id];  // a copy: adding nodes moves them
        const std::vector<FieldId> below = field::children(node);
        const auto* cells = std::get_if<field::Cells>(&node);
        if (cells) around_.push_back(*cells);
        for (const FieldId child : below) walk(child);
        if (cells) around_.pop_back();
        if (below.empty()) found.push_back(within_cells(id));
    }

    FieldId within_cells(FieldId id) {
        for (field::Cells cells : around_ | std::views::reverse) {
            cells.a = id;
            id = field_.add(std::move(cells));
        }
        return id;
    }

    field::Field& field_;
    std::vector<field::Cells> around_{};
};

}  // namespace

SceneFacts find_facts(const field::Field& field, const Region& region,
                      std::span<const double> parameters) {
    field::Field copy = field;
    const Copies objects(copy);
    Finder finder(copy, region, parameters);
    SceneFacts scene{finder.find(field.root), {}};
    for (const FieldId object : objects.found) scene.objects.push_back(finder.find(object));
    return scene;
}

}  // namespace analysis
