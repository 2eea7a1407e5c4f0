// SPDX-License-Identifier: MIT
#include "formula/grammar.h"

#include <boost/spirit/home/x3.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "formula/building.h"
#include "formula/number.h"

namespace boost::spirit::x3 {

/// A parser with an action is called what the parser is called.
template <class Subject, class Action>
struct get_info<action<Subject, Action>> {
    using result_type = std::string;
    std::string operator()(const action<Subject, Action>& parser) const {
        return what(parser.subject);
    }
};

}  // namespace boost::spirit::x3

namespace formula {
namespace {

namespace x3 = boost::spirit::x3;

struct building_tag;

template <class Context>
Building& building(const Context& context) {
    return x3::get<building_tag>(context);
}

/// A parser of a token: skips blanks and comments, then lets `match` say where the token ends (at
/// its beginning if there is none). Its attribute is the token's text.
template <class Match>
struct TokenParser : x3::parser<TokenParser<Match>> {
    using attribute_type = std::string_view;
    static constexpr bool has_attribute = true;

    explicit TokenParser(Match function) : match(function) {}

    template <class Context, class RuleContext, class Attribute>
    bool parse(Place& first, const Place& last, const Context& context, RuleContext&,
               Attribute& attribute) const {
        Place begin = first;
        x3::skip_over(begin, last, context);
        const Place end = match(building(context), begin, last);
        if (end == begin) return false;
        x3::traits::move_to(between(begin, end), attribute);
        first = end;
        return true;
    }

    Match match;
};

/// A parser of nothing: succeeds where `holds` is true, before any blank is skipped.
template <class Holds>
struct Condition : x3::parser<Condition<Holds>> {
    using attribute_type = x3::unused_type;
    static constexpr bool has_attribute = false;

    explicit Condition(Holds function) : holds(function) {}

    template <class Context, class RuleContext, class Attribute>
    bool parse(Place& first, const Place& last, const Context& context, RuleContext&,
               Attribute&) const {
        return holds(building(context), first, last);
    }

    Holds holds;
};

const TokenParser number_token([](const Building&, Place first, Place last) {
    return number_end(first, last);
});
const TokenParser name_token([](const Building& building, Place first, Place last) {
    return name_end(building, first, last);
});
const TokenParser word_token([](const Building&, Place first, Place last) {
    return word_end(first, last);
});

const Condition call_follows([](const Building&, Place first, Place last) {
    return opens_bracket(first, last);
});
const Condition product_is_implied(implies_product);
const Condition components_follow(selects_components);

using Operands = std::vector<Operand>;
using Expressions = std::vector<ExpressionId>;
struct Signed {
    bool negative = false;
    ExpressionId expression{};
    base::SourceSpan span;  ///< with the signs
};
struct Called {
    std::string_view name;
    std::optional<Expressions> arguments;
};

// Sets the span of what was just built. Rules whose parts have actions get no attribute here, so
// each of these is a rule of its own around the rule that builds.
struct spanned {
    template <class Context>
    void on_success(Place first, Place last, ExpressionId& id, const Context& context) {
        Building& state = building(context);
        Expression& expression = state.program.expressions[index(id)];
        // A name keeps its own span, so that errors about it point at it and not at its brackets.
        const bool name = std::holds_alternative<Name>(expression.node);
        if (!name) expression.span = state.span(first, last);
        if (std::holds_alternative<Number>(expression.node)) state.number_end = last;
    }
};
struct primary_tag : spanned {};
struct operand_tag : spanned {};
struct signed_tag {
    template <class Context>
    void on_success(Place first, Place last, Signed& value, const Context& context) {
        value.span = building(context).span(first, last);
    }
};

// What a rule is called is what an error says was expected.
const x3::rule<struct expression_tag, ExpressionId> expression = "expression";
const x3::rule<struct union_tag, Operands> union_chain = "expression";
const x3::rule<struct intersection_tag, ExpressionId> intersection = "expression";
const x3::rule<struct intersection_chain_tag, Operands> intersection_chain = "expression";
const x3::rule<struct comparison_tag, ExpressionId> comparison = "expression";
const x3::rule<struct sum_tag, ExpressionId> sum = "expression";
const x3::rule<struct sum_chain_tag, Operands> sum_chain = "expression";
const x3::rule<struct product_tag, ExpressionId> product = "expression";
const x3::rule<struct product_chain_tag, Operands> product_chain = "expression";
const x3::rule<struct power_tag, ExpressionId> power = "expression";
const x3::rule<struct power_chain_tag, std::vector<Signed>> power_chain = "expression";
const x3::rule<signed_tag, Signed> signed_primary = "expression";
const x3::rule<struct signed_parts_tag, Signed> signed_parts = "expression";
const x3::rule<primary_tag, ExpressionId> primary = "expression";
const x3::rule<struct primary_parts_tag, ExpressionId> primary_parts = "expression";
const x3::rule<operand_tag, ExpressionId> operand = "expression";
const x3::rule<struct operand_parts_tag, ExpressionId> operand_parts = "expression";
const x3::rule<struct called_tag, Called> called = "expression";
const x3::rule<struct arguments_tag, Expressions> arguments = "arguments";
const x3::rule<struct bracketed_tag, Expressions> bracketed = "expression";

/// Adds an operand to the chain that the rule builds.
auto join(Joint joint) {
    return [joint](auto& context) { x3::_val(context).push_back({joint, x3::_attr(context)}); };
}

/// Turns a chain into a node, or into its only operand.
template <class Chain>
auto collect() {
    return [](auto& context) {
        Operands& operands = x3::_attr(context);
        Building& state = building(context);
        const ExpressionId first = operands.front().expression;
        const ExpressionId last = operands.back().expression;
        const base::SourceSpan span =
            base::cover(state.program[first].span, state.program[last].span);
        x3::_val(context) =
            operands.size() == 1 ? first : state.add(Chain{std::move(operands)}, span);
    };
}

const auto pass_on = [](auto& context) { x3::_val(context) = x3::_attr(context); };
const auto append = [](auto& context) { x3::_val(context).push_back(x3::_attr(context)); };

auto relate(Relation relation) {
    return [relation](auto& context) {
        Building& state = building(context);
        const ExpressionId left = x3::_val(context);
        const ExpressionId right = x3::_attr(context);
        const base::SourceSpan span =
            base::cover(state.program[left].span, state.program[right].span);
        x3::_val(context) = state.add(Comparison{relation, left, right}, span);
    };
}

/// From the right: each exponent is the whole rest of the chain, and a sign is applied to all that
/// is right of it.
const auto fold_powers = [](auto& context) {
    Building& state = building(context);
    const std::vector<Signed>& chain = x3::_attr(context);
    ExpressionId value{};
    base::SourceSpan span;
    for (std::size_t i = chain.size(); i-- > 0;) {
        const bool last = i + 1 == chain.size();
        const base::SourceSpan base_span = state.program[chain[i].expression].span;
        span = last ? base_span : base::cover(base_span, span);
        value = last ? chain[i].expression : state.add(Power{chain[i].expression, value}, span);
        span = base::cover(chain[i].span, span);
        if (chain[i].negative) value = state.add(Negate{value}, span);
    }
    x3::_val(context) = value;
};

const auto flip_sign = [](auto& context) {
    x3::_val(context).negative = !x3::_val(context).negative;
};
const auto set_operand = [](auto& context) { x3::_val(context).expression = x3::_attr(context); };

const auto make_number = [](auto& context) {
    Building& state = building(context);
    const std::string_view spelling = x3::_attr(context);
    const std::optional<double> value = number_value(spelling);
    if (!value) {
        state.errors.push_back(
            base::error(state.span(spelling.data(), spelling.data() + spelling.size()),
                        "the number is too large; the largest is about 1.8e308"));
    }
    x3::_val(context) = state.add(Number{value.value_or(0)}, {});
};

const auto set_name = [](auto& context) { x3::_val(context).name = x3::_attr(context); };
const auto set_arguments = [](auto& context) {
    x3::_val(context).arguments = std::move(x3::_attr(context));
};
const auto make_called = [](auto& context) {
    Building& state = building(context);
    Called& it = x3::_attr(context);
    const base::SourceSpan span = state.span(it.name.data(), it.name.data() + it.name.size());
    x3::_val(context) =
        it.arguments ? state.add(Call{std::string(it.name), span, std::move(*it.arguments)}, span)
                     : state.add(Name{std::string(it.name)}, span);
};
const auto make_bracketed = [](auto& context) {
    Expressions& inside = x3::_attr(context);
    x3::_val(context) =
        inside.size() == 1 ? inside.front() : building(context).add(Tuple{std::move(inside)}, {});
};

/// Takes components from what the rule has built.
const auto select_components = [](auto& context) {
    Building& state = building(context);
    const std::string_view letters = x3::_attr(context);
    const base::SourceSpan span = state.span(letters.data(), letters.data() + letters.size());
    check_components(letters, span, state.errors);
    const ExpressionId operand = x3::_val(context);
    const base::SourceSpan whole = base::cover(state.program[operand].span, span);
    x3::_val(context) = state.add(Component{operand, std::string(letters), span}, whole);
};

const auto components = x3::rule<struct components_tag, std::string_view>{"component"} = word_token;
const auto closing = x3::rule<struct closing_tag>{"')'"} = x3::lit(')');

const auto expression_def = union_chain[collect<Union>()];
const auto union_chain_def = intersection[join(Joint::either)] >>
                             *('|' > intersection[join(Joint::either)]);
const auto intersection_def = intersection_chain[collect<Intersection>()];
const auto intersection_chain_def = comparison[join(Joint::both)] >>
                                    *(('&' > comparison[join(Joint::both)]) |
                                      ('\\' > comparison[join(Joint::without)]));
const auto comparison_def = sum[pass_on] >>
                            -((x3::lit("<=") > sum[relate(Relation::less_equal)]) |
                              (x3::lit(">=") > sum[relate(Relation::greater_equal)]) |
                              ('<' > sum[relate(Relation::less)]) |
                              ('>' > sum[relate(Relation::greater)]) |
                              ('=' > sum[relate(Relation::equal)]));
const auto sum_def = sum_chain[collect<Sum>()];
const auto sum_chain_def = product[join(Joint::plus)] >> *(('+' > product[join(Joint::plus)]) |
                                                           ('-' > product[join(Joint::minus)]));
const auto product_def = product_chain[collect<Product>()];
const auto product_chain_def = power[join(Joint::times)] >>
                               *((product_is_implied > power[join(Joint::implied_times)]) |
                                 ('*' > power[join(Joint::times)]) |
                                 ('/' > power[join(Joint::over)]));
const auto power_def = power_chain[fold_powers];
const auto power_chain_def = signed_primary[append] >> *('^' > signed_primary[append]);
const auto signed_primary_def = signed_parts;
const auto signed_parts_def =
    primary[set_operand] | (+(x3::lit('-')[flip_sign] | '+') > primary[set_operand]);
const auto primary_def = primary_parts;
const auto primary_parts_def =
    number_token[make_number] |
    (operand[pass_on] >> *(components_follow >> x3::lexeme['.' > components[select_components]]));
const auto operand_def = operand_parts;
const auto operand_parts_def = called[make_called] | bracketed[make_bracketed];
const auto called_def = name_token[set_name] >> -(call_follows >> arguments[set_arguments]);
const auto arguments_def = '(' > -(expression[append] >> *(',' > expression[append])) > closing;
const auto bracketed_def = '(' > expression[append] > *(',' > expression[append]) > closing;

BOOST_SPIRIT_DEFINE(expression, union_chain, intersection, intersection_chain, comparison, sum,
                    sum_chain, product, product_chain, power, power_chain, signed_primary,
                    signed_parts, primary, primary_parts, operand, operand_parts, called, arguments,
                    bracketed)

const auto blank_or_comment = x3::char_(" \t\r\n") | ('#' >> *(x3::char_ - '\n'));
const auto end = x3::rule<struct end_tag>{"end"} = x3::eoi;

/// Parses from `first` on, which becomes the place behind what fits.
template <class Parser>
Parsed<ExpressionId> run(const Parser& parser, Place& first, Place last, Building& state) {
    const auto place = [&](Place at) { return static_cast<std::uint32_t>(at - state.text); };
    ExpressionId id{};
    try {
        if (x3::phrase_parse(first, last, x3::with<building_tag>(state)[parser], blank_or_comment,
                             id)) {
            return id;
        }
    } catch (const x3::expectation_failure<Place>& failure) {
        return SyntaxError{place(failure.where()), failure.which()};
    }
    return SyntaxError{place(first), "expression"};
}

}  // namespace

Parsed<ExpressionId> parse_expression(std::string_view text, base::SourceSpan span,
                                      Program& program, base::Diagnostics& errors) {
    Building state{text.data(), program, errors};
    Place first = text.data() + span.begin;
    return run(expression > end, first, text.data() + span.end, state);
}

Parsed<Front> parse_front(std::string_view text, base::SourceSpan span, Extent extent,
                          Within within, Program& program, base::Diagnostics& errors) {
    Building state{text.data(), program, errors, within};
    Place first = text.data() + span.begin;
    const Place last = text.data() + span.end;
    Parsed<ExpressionId> parsed =
        extent == Extent::sum ? run(sum, first, last, state) : run(expression, first, last, state);
    if (auto* failure = std::get_if<SyntaxError>(&parsed)) return std::move(*failure);
    return Front{std::get<ExpressionId>(parsed), state.span(first, first).end};
}

}  // namespace formula
