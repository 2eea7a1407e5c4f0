// SPDX-License-Identifier: MIT
#include "analysis/content.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "field/parts.h"

namespace analysis {
namespace {

using field::FieldId;
using graph::NodeId;
using numeric::infinity;
using numeric::Interval;

/// More turns of an iteration are not followed.
constexpr double most_turns = 1000;

/// True if a value at which an expression is not defined may be an infinity of either sign and what
/// comes of it, which intervals leave out, instead of NaN: behind a division by zero.
bool may_have_poles(const graph::Graph& graph, std::span<const NodeId> roots) {
    const auto constant_from = [&](NodeId id, double least) {
        return graph.is_constant(id) && graph[id].value >= least;
    };
    return std::ranges::any_of(reachable(graph, roots), [&](NodeId id) {
        const graph::Node& node = graph[id];
        if (node.op == graph::Op::pow) return !constant_from(node.args()[1], 0);
        return node.op == graph::Op::div &&
               (!graph.is_constant(node.args()[1]) || graph.is_constant(node.args()[1], 0));
    });
}

/// The values of a solid: outside of its domain is outside.
Interval solid_value(const Interval& value, bool poles) {
    if (poles && value.partial) return Interval::whole();
    if (value.is_empty()) return infinity;
    return {value.lo, value.partial ? infinity : value.hi};
}

/// All values of both, without flags.
Interval both(const Interval& a, const Interval& b) {
    return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
}

}  // namespace

ContentFinder::ContentFinder(const field::Field& field, FieldId id,
                             std::span<const double> parameters)
    : field_(field),
      root_(id),
      parameters_(parameters.begin(), parameters.end()),
      variables_(field.graph.variable_count()) {
    parameters_.resize(field.graph.parameter_count(), Interval(0.0));
    prepare(id);
    formula_tape_ = eval::make_tape(field.graph, formulas_);
    eval::load_parameters<Interval>(formula_tape_, parameters_, formula_registers_);
    formula_values_.resize(formulas_.size());
    operations_ += formula_tape_.instructions.size();
}

double ContentFinder::number(NodeId id) {
    const Interval value = run(eval::make_tape(field_.graph, std::array{id}))[0];
    return value.is_empty() ? std::nan("") : 0.5 * value.lo + 0.5 * value.hi;
}

void ContentFinder::prepare(const field::Iteration& iteration, FieldId id) {
    const auto tape = [&](std::span<const NodeId> roots) {
        return eval::make_tape(field_.graph, roots);
    };
    const auto one = [&](NodeId root) { return tape(std::span(&root, 1)); };
    Loop loop{iteration,
              tape(iteration.start),
              tape(iteration.step),
              iteration.escape ? one(*iteration.escape) : eval::Tape{},
              one(iteration.distance),
              std::round(number(iteration.limit)),
              may_have_poles(field_.graph, field::expressions(iteration))};
    const std::size_t turn = loop.step.instructions.size() + loop.escape.instructions.size() +
                             loop.distance.instructions.size();
    const double turns = loop.limit <= most_turns ? std::max(loop.limit, 0.0) + 1 : 0;
    operations_ += loop.start.instructions.size() + turn * static_cast<std::size_t>(turns);
    loops_.emplace(id, std::move(loop));
}

void ContentFinder::prepare(FieldId id) {
    const field::Node node = field::shape(field_, id);
    if (const auto* leaf = std::get_if<field::Formula>(&node)) {
        const bool fresh = formula_of_.try_emplace(id, formulas_.size()).second;
        if (!fresh) return;
        formulas_.push_back(leaf->value);
        poles_.push_back(may_have_poles(field_.graph, std::span(&leaf->value, 1)));
    } else if (const auto* iteration = std::get_if<field::Iteration>(&node)) {
        if (!loops_.contains(id)) prepare(*iteration, id);
    } else if (const auto* cells = std::get_if<field::Cells>(&node)) {
        return prepare(*cells, id);
    } else if (const std::vector<NodeId> own = field::expressions(node); !own.empty()) {
        const eval::Tape& tape = tapes_[id] = eval::make_tape(field_.graph, own);
        operations_ += tape.instructions.size();
    }
    for (const FieldId child : field::children(node)) prepare(child);
}

/// What is in the cells sees other coordinates, and nothing of what is around them.
void ContentFinder::prepare(const field::Cells& cells, FieldId id) {
    std::vector<double> parameters;
    for (const Interval& it : parameters_) parameters.push_back(it.lo);
    inside_[id] = std::make_unique<ContentFinder>(field_, cells.a, parameters);
    const eval::Tape& tape = tapes_[id] = eval::make_tape(field_.graph, cells.point);
    operations_ += tape.instructions.size() + inside_[id]->operations();
}

std::span<const Interval> ContentFinder::run(const eval::Tape& tape) {
    results_.resize(tape.roots.size());
    eval::evaluate<Interval>(tape, variables_, parameters_, results_, scratch_);
    return results_;
}

/// The answers of all turns at which a point of the cell may escape, and -infinity if one may never
/// escape.
Interval ContentFinder::follow(const Loop& loop) {
    const field::Iteration& iteration = loop.iteration;
    if (loop.limit > most_turns) return Interval::whole();
    const auto set_state = [&](std::span<const Interval> state) {
        for (std::size_t i = 0; i < iteration.state.size(); ++i) {
            variables_[index(iteration.state[i])] = state[i];
        }
    };
    set_state(run(loop.start));
    Interval answers{infinity, -infinity};
    for (double turn = 0;; ++turn) {
        if (iteration.escape) {
            const Interval escape = run(loop.escape)[0];
            const bool may = escape.hi > 0 || (loop.poles && escape.partial);
            if (may) answers = both(answers, solid_value(run(loop.distance)[0], loop.poles));
            if (may && escape.lo > 0 && !escape.partial) return answers;
        }
        if (!(turn < loop.limit)) break;
        set_state(run(loop.step));
    }
    if (iteration.escape) return both(answers, -infinity);
    return solid_value(run(loop.distance)[0], loop.poles);
}

struct ContentFinder::Visitor {
    ContentFinder& finder;
    FieldId id;

    Content operator()(const field::Formula& leaf) const {
        const std::size_t place = finder.formula_of_.at(id);
        const Interval& value = finder.formula_values_[place];
        const bool poles = finder.poles_[place];
        if (leaf.kind == field::Kind::solid) return {solid_value(value, poles), false};
        return {infinity, value.contains(0) || (poles && value.partial)};
    }
    Content operator()(const field::Iteration&) const {
        return {finder.follow(finder.loops_.at(id)), false};
    }
    Content operator()(const field::Complement& node) const {
        const Interval inner = finder.content(node.a).solid;
        return {{-inner.hi, -inner.lo}, false};
    }
    Content operator()(const field::Union& node) const {
        const Content a = finder.content(node.a), b = finder.content(node.b);
        return {numeric::min(a.solid, b.solid), a.sheet || b.sheet};
    }
    Content operator()(const field::Intersection& node) const {
        const Content a = finder.content(node.a), b = finder.content(node.b);
        const bool sheet = (a.sheet && !b.proven_empty()) || (b.sheet && !a.proven_empty());
        return {numeric::max(a.solid, b.solid), sheet};
    }
    Content operator()(const field::Blend& node) const {
        for (std::size_t i = 0; i < node.operands.size(); ++i) {
            const Interval value = finder.content(node.operands[i]).solid;
            const auto nearer = [](double end) {
                return std::clamp(end, -field::unknown_depth, field::unknown_depth);
            };
            finder.variables_[index(node.values[i])] = {nearer(value.lo), nearer(value.hi)};
        }
        const std::span<const Interval> roots = finder.run(finder.tapes_.at(id));
        Interval value = roots[0];
        if (node.displacement) value = numeric::add(value, solid_value(roots[1], true));
        return {solid_value(value, true), false};
    }
    Content operator()(const field::Choice& node) const {
        const std::span<const Interval> sides = finder.run(finder.tapes_.at(id));
        const Interval less = sides[0], than = sides[1];
        if (less.hi < than.lo) return finder.content(node.a);
        if (less.lo >= than.hi) return finder.content(node.b);
        const Content a = finder.content(node.a), b = finder.content(node.b);
        return {both(a.solid, b.solid), a.sheet || b.sheet};
    }
    Content operator()(const field::Cells& node) const {
        const std::span<const Interval> point = finder.run(finder.tapes_.at(id));
        if (std::ranges::any_of(point, [](const Interval& it) { return it.partial; })) {
            return {Interval::whole(), kind_of(finder.field_, node.a) == field::Kind::sheet};
        }
        return finder.inside_.at(id)->over(std::array{point[0], point[1], point[2]});
    }
};

Content ContentFinder::content(FieldId id) { return std::visit(Visitor{*this, id}, field_[id]); }

Content ContentFinder::over(const std::array<Interval, 3>& sides) {
    for (std::size_t i = 0; i < sides.size(); ++i) variables_[i] = sides[i];
    eval::evaluate_loaded<Interval>(formula_tape_, variables_, formula_values_, formula_registers_);
    return content(root_);
}

Content ContentFinder::over(const Cell& cell) { return over(cell.sides()); }

}  // namespace analysis
