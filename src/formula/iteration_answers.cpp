// SPDX-License-Identifier: MIT
#include "formula/iteration_answers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "eval/heuristic_equal.h"
#include "field/palette.h"
#include "formula/vector.h"
#include "graph/build.h"
#include "graph/substitute.h"
#include "passes/distance_estimate.h"

namespace formula {
namespace {

using graph::Expr;
using graph::NodeId;

/// How the orbit grows once it is large: passes::Escape without the radius.
struct Form {
    bool by_power = true;
    std::optional<NodeId> rate{};  ///< none if it is another one at every turn
};

class Answers {
public:
    Answers(Lowering& lowering, const Iterate& iterate, Turns turns, base::SourceSpan span)
        : lowering_(lowering), iterate_(iterate), turns_(std::move(turns)), span_(span) {}

    Value lower() {
        if (!turns_.failed) find_radius();
        InnerScope scope(lowering_);
        smooth_ = graph().new_variable("smooth_turns");
        const Binding* growth = special("growth", turns_.growth);
        special("turns", turns_.done);
        const Binding* smooth = special("smooth_turns", smooth_);
        std::optional<NodeId> distance;
        if (iterate_.distance) distance = lower_distance(*iterate_.distance);
        std::optional<field::Colour> colour;
        if (iterate_.colour) colour = lower_colour(*iterate_.colour);
        failed_ = turns_.failed || (iterate_.distance && !distance) || (iterate_.colour && !colour);
        if (failed_) return Nothing{};
        if (growth && growth->used) use_growth();
        if (smooth && smooth->used) use_smooth_turns();
        if (!distance) distance = derived_distance();
        if (failed_ || !distance) return Nothing{};
        turns_.iteration.distance = replaced(*distance);
        if (colour) {
            for (NodeId& part : *colour) part = replaced(part);
        }
        turns_.iteration.colour = colour;
        if (turns_.until) turns_.iteration.escape = escape_condition();
        drop_unneeded_state();
        return FieldValue{lowering_.field.add(std::move(turns_.iteration)), 1};
    }

private:
    graph::Graph& graph() { return lowering_.field.graph; }
    Expr expr(NodeId id) { return {graph(), id}; }
    void fail(base::SourceSpan span, std::string message) {
        lowering_.error(span, std::move(message));
        failed_ = true;
    }

    /// Names a number that is known after the last turn, unless the text gives the name a meaning.
    const Binding* special(std::string_view name, graph::VariableId id) {
        if (find_binding(lowering_.scope, name)) return nullptr;
        return &lowering_.scope->set(name, graph().variable(id), span_, Role::state);
    }
    NodeId replaced(NodeId answer) {
        return substitute(graph(), std::array{answer}, replacements_)[0];
    }

    const std::string& orbit_name() const { return iterate_.state[0].name; }
    std::vector<NodeId> orbit() const {
        if (const auto* vector = std::get_if<VectorValue>(&turns_.orbit)) return vector->components;
        return {std::get<NodeId>(turns_.orbit)};
    }

    /// Whether the iteration ends where |z| > radius.
    void find_radius() {
        const Components z = components(graph(), orbit());
        length_ = (z.size() == 1 ? abs(z[0]) : length(z)).id;
        square_ = dot(z, z).id;
        if (!turns_.until) return;
        const auto [large, small, span] = *turns_.until;
        if (lowering_.facts.depends_on_point(graph(), small)) return;
        if (eval::heuristic_equal(graph(), large, *square_)) radius_ = sqrt(expr(small)).id;
        if (eval::heuristic_equal(graph(), large, *length_)) radius_ = small;
    }

    /// What ends the iteration; of |z| > radius the squares, which need no root.
    NodeId escape_condition() {
        const auto [large, small, span] = *turns_.until;
        if (!radius_) return (expr(large) - expr(small)).id;
        const bool squared = small != *radius_;
        return (expr(*square_) - (squared ? expr(small) : expr(small) * expr(small))).id;
    }

    void drop_unneeded_state() {
        field::Iteration& it = turns_.iteration;
        std::vector<NodeId> answers{it.distance};
        if (it.evenness) answers.push_back(*it.evenness);
        if (it.colour) answers.insert(answers.end(), it.colour->begin(), it.colour->end());
        const std::vector<bool> needed = field::needed_state(graph(), it, answers);
        std::size_t kept = 0;
        for (std::size_t i = 0; i < needed.size(); ++i) {
            if (!needed[i]) continue;
            it.state[kept] = it.state[i];
            it.start[kept] = it.start[i];
            it.step[kept++] = it.step[i];
        }
        it.state.resize(kept);
        it.start.resize(kept);
        it.step.resize(kept);
    }

    std::optional<NodeId> lower_distance(ExpressionId id) {
        const std::string hint =
            fmt::format("write a number, such as '(length({}) - 1)/growth'", orbit_name());
        return as_number(lowering_, id, "as a distance", hint);
    }

    std::optional<field::Colour> lower_colour(ExpressionId id) {
        const Value value = lower_expression(lowering_, id);
        if (const auto* number = std::get_if<NodeId>(&value)) {
            return field::palette(graph(), *number);
        }
        const auto* vector = std::get_if<VectorValue>(&value);
        if (vector && vector->components.size() == 3) {
            return field::Colour{vector->components[0], vector->components[1],
                                 vector->components[2]};
        }
        if (!is_nothing(value)) {
            lowering_.error(
                lowering_.span(id),
                fmt::format("a colour is a number or a vector of 3, not {}", describe(value)));
        }
        return std::nullopt;
    }

    /// The running derivative, added to the state: as one number where the rules of orbits know it.
    NodeId use_growth() {
        if (growth_) return *growth_;
        if (turns_.start && turns_.next) {
            growth_ =
                passes::add_growth(graph(), turns_.iteration,
                                   {turns_.growth, turns_.start->stretch, turns_.next->stretch});
        } else {
            growth_ = passes::add_jacobian_norm(graph(), turns_.iteration, orbit().size());
        }
        replacements_.emplace_back(turns_.growth, *growth_);
        return *growth_;
    }

    std::optional<Form> form() {
        if (turns_.next) {
            const NodeId degree = turns_.next->degree, scale = turns_.next->scale;
            const auto known = lowering_.facts.constant(graph(), degree);
            if (!known && lowering_.facts.depends_on_point(graph(), degree)) return Form{true, {}};
            if (!known || *known > 1) return Form{true, degree};
            if (lowering_.facts.depends_on_point(graph(), scale)) return Form{false, {}};
            const auto factor = lowering_.facts.constant(graph(), scale);
            const bool grows = *known == 1 && (!factor || *factor > 1);
            return grows ? std::optional(Form{false, scale}) : std::nullopt;
        }
        const std::vector<graph::VariableId> state(
            turns_.iteration.state.begin(),
            turns_.iteration.state.begin() + static_cast<std::ptrdiff_t>(orbit().size()));
        double degree = 0;
        for (std::size_t i = 0; i < state.size(); ++i) {
            const auto order = passes::heuristic_order(graph(), turns_.iteration.step[i], state);
            if (!order) return std::nullopt;
            degree = std::max(degree, *order);
        }
        if (!(degree > 1)) return std::nullopt;
        return Form{true, graph().constant(degree)};
    }

    /// How the orbit escapes; reports why that cannot be told. `what` cannot be told then.
    std::optional<passes::Escape> escape(std::string_view what) {
        const std::string until = fmt::format("'until length({}) > 4'", orbit_name());
        if (!turns_.until) {
            fail(span_, fmt::format("{} cannot be told without {}", what, until));
            return std::nullopt;
        }
        if (!radius_) {
            fail(turns_.until->span,
                 fmt::format("{} cannot be told from this condition; write {}", what, until));
            return std::nullopt;
        }
        const std::optional<Form> found = form();
        if (!found) {
            fail(span_,
                 fmt::format("{} cannot be told, since it is unknown how '{}' grows from turn "
                             "to turn",
                             what, orbit_name()));
            return std::nullopt;
        }
        const auto known = lowering_.facts.constant(graph(), *radius_);
        if (found->by_power && known && !(*known > 1)) {
            fail(turns_.until->span,
                 fmt::format("{} cannot be told unless the radius is above 1", what));
            return std::nullopt;
        }
        return passes::Escape{found->by_power, found->rate, *radius_};
    }

    std::optional<NodeId> derived_distance() {
        const auto how = escape("the distance");
        if (!how) {
            lowering_.errors.back().message += "; or give 'distance = …' in the body";
            return std::nullopt;
        }
        const NodeId growth = use_growth();
        if (turns_.next && how->by_power) turns_.iteration.evenness = evenness(growth);
        return passes::distance_estimate(graph(), turns_.iteration, *length_, *how, growth);
    }

    /// What field::Iteration::evenness says, if the rules of orbits know it.
    std::optional<NodeId> evenness(NodeId growth) {
        const auto& vector = std::get<VectorValue>(turns_.orbit);
        if (vector.algebra == Algebra::vector) return std::nullopt;
        if (vector.algebra != Algebra::triplex) return graph().constant(1);
        if (!turns_.start || !turns_.next->across) return std::nullopt;
        const NodeId start = turns_.start->across.value_or(turns_.start->stretch);
        const NodeId across = passes::add_growth(graph(), turns_.iteration,
                                                 {turns_.across, start, *turns_.next->across});
        return sqrt(expr(growth) / expr(across)).id;
    }

    /// turns - log(log|z| / log radius) / log degree, or turns - log(|z| / radius) / log scale: as
    /// smooth as the orbit's size, and the number of turns where that is the radius.
    void use_smooth_turns() {
        const auto how = escape("'smooth_turns'");
        if (how && !how->rate) {
            fail(span_, fmt::format("'smooth_turns' cannot be told, since '{}' grows differently "
                                    "from turn to turn",
                                    orbit_name()));
        }
        if (!how || !how->rate) return;
        const Expr radius = expr(how->radius);
        const Expr size = max(expr(*length_), radius);  // never escaped is not beyond
        const Expr beyond = how->by_power ? log(size) / log(radius) : size / radius;
        const Expr turns = expr(graph().variable(turns_.done));
        const Expr smooth = turns - log(beyond) / log(expr(*how->rate));
        replacements_.emplace_back(smooth_, smooth.id);
    }

    Lowering& lowering_;
    const Iterate& iterate_;
    Turns turns_;
    base::SourceSpan span_;
    graph::VariableId smooth_{};
    std::optional<NodeId> length_{}, square_{};  ///< |z| and |z|^2
    std::optional<NodeId> radius_{};
    std::optional<NodeId> growth_{};
    std::vector<std::pair<graph::VariableId, NodeId>> replacements_{};
    bool failed_ = false;
};

}  // namespace

Value lower_answers(Lowering& lowering, const Iterate& iterate, Turns turns,
                    base::SourceSpan span) {
    return Answers(lowering, iterate, std::move(turns), span).lower();
}

}  // namespace formula
