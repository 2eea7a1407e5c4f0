// SPDX-License-Identifier: MIT
#include "formula/print_formula.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <initializer_list>
#include <iterator>
#include <string_view>
#include <utility>

namespace formula {
namespace {

/// From the loosest to the tightest.
enum class Level { expression, intersection, comparison, sum, product, power, primary };

struct LevelOf {
    Level operator()(const Union&) const { return Level::expression; }
    Level operator()(const Intersection&) const { return Level::intersection; }
    Level operator()(const Comparison&) const { return Level::comparison; }
    Level operator()(const Sum&) const { return Level::sum; }
    Level operator()(const Product&) const { return Level::product; }
    Level operator()(const Power&) const { return Level::power; }
    Level operator()(const Negate&) const { return Level::power; }
    Level operator()(const auto&) const { return Level::primary; }
};

std::string_view between(Joint joint) {
    switch (joint) {
        case Joint::plus:
            return " + ";
        case Joint::minus:
            return " - ";
        case Joint::times:
            return "*";
        case Joint::over:
            return "/";
        case Joint::implied_times:
            return "";
        case Joint::both:
            return " & ";
        case Joint::without:
            return " \\ ";
        case Joint::either:
            return " | ";
    }
    return "";
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// True for texts such as `e2`, which make another number of one that stands before them.
bool looks_like_exponent(std::string_view text) {
    return text.size() > 1 && (text[0] == 'e' || text[0] == 'E') && is_digit(text[1]);
}

struct Printer {
    const Program& program;
    std::string out{};
    std::size_t number_end = 0;  ///< where the last number ended

    /// Puts brackets around what was printed from a place on.
    void bracket(std::size_t begin) {
        out.insert(begin, "(");
        out += ')';
    }

    /// In brackets if it binds looser than `least`.
    void print(ExpressionId id, Level least) {
        const ExpressionNode& node = program[id].node;
        const std::size_t begin = out.size();
        std::visit(*this, node);
        if (std::visit(LevelOf{}, node) < least) bracket(begin);
    }

    void print_list(const std::vector<ExpressionId>& list) {
        out += '(';
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (i > 0) out += ", ";
            print(list[i], Level::expression);
        }
        out += ')';
    }

    /// Makes a product of the texts from `left` to `right` and from there on, by brackets where
    /// they are needed. Returns where the second text begins then.
    std::size_t imply_product(std::size_t left, std::size_t right, bool behind_number) {
        const std::string_view second = std::string_view(out).substr(right);
        if (second[0] == '-' || (behind_number && looks_like_exponent(second))) bracket(right);
        const bool joined = out[right - 1] == ')' || (behind_number && !is_digit(out[right]));
        if (joined) return right;
        out.insert(right, ")");
        out.insert(left, "(");
        number_end += 2;
        return right + 2;
    }

    void print_chain(const std::vector<Operand>& operands, Level least) {
        std::size_t left = out.size();
        for (std::size_t i = 0; i < operands.size(); ++i) {
            const Joint joint = operands[i].joint;
            if (i > 0) out += between(joint);
            const std::size_t right = out.size();
            const bool behind_number = number_end == right;
            print(operands[i].expression, least);
            const bool implied = i > 0 && joint == Joint::implied_times;
            left = implied ? imply_product(left, right, behind_number) : right;
        }
    }

    void operator()(const Number& number) {
        fmt::format_to(std::back_inserter(out), "{}", number.value);
        number_end = out.size();
    }
    void operator()(const Name& name) { out += name.text; }
    void operator()(const Negate& negate) {
        out += '-';
        const std::size_t begin = out.size();
        print(negate.operand, Level::power);
        if (out[begin] == '-') bracket(begin);
    }
    void operator()(const Power& power) {
        print(power.base, Level::primary);
        out += '^';
        print(power.exponent, Level::power);
    }
    void operator()(const Sum& sum) { print_chain(sum.operands, Level::product); }
    void operator()(const Product& product) { print_chain(product.operands, Level::power); }
    void operator()(const Intersection& it) { print_chain(it.operands, Level::comparison); }
    void operator()(const Union& it) { print_chain(it.operands, Level::intersection); }
    void operator()(const Comparison& comparison) {
        print(comparison.left, Level::sum);
        fmt::format_to(std::back_inserter(out), " {} ", spelling(comparison.relation));
        print(comparison.right, Level::sum);
    }
    void operator()(const Call& call) {
        out += call.function;
        print_list(call.arguments);
    }
    void operator()(const Tuple& tuple) { print_list(tuple.parts); }
    void operator()(const Component& component) {
        const std::size_t begin = out.size();
        print(component.operand, Level::primary);
        if (is_digit(out[begin])) bracket(begin);
        out += '.';
        out += component.letters;
    }
    void operator()(const Broken&) { assert(false); }

    void print_assignment(std::string_view name, ExpressionId value) {
        out += name;
        out += " = ";
        print(value, Level::sum);
    }
    void print_line(std::string_view name, ExpressionId value) {
        out += "\n    ";
        print_assignment(name, value);
    }
    void operator()(const Iterate& iterate) {
        std::string_view before = "iterate ";
        for (const Assignment& it : iterate.state) {
            out += before;
            print_assignment(it.name, it.value);
            before = ", ";
        }
        out += " for ";
        print(iterate.limit, Level::sum);
        if (iterate.until) {
            out += " until ";
            print(*iterate.until, Level::expression);
        }
        out += ':';
        for (const Assignment& it : iterate.body) print_line(it.name, it.value);
        if (iterate.distance) print_line("distance", *iterate.distance);
        if (iterate.colour) print_line("colour", *iterate.colour);
    }

    void operator()(const Definition& definition) {
        out += definition.name;
        if (definition.parameters) {
            std::string_view before = "(";
            for (const FunctionParameter& it : *definition.parameters) {
                out += before;
                before = ", ";
                if (it.initial) {
                    print_assignment(it.name, *it.initial);
                } else {
                    out += it.name;
                }
            }
            out += ')';
        }
        out += " = ";
        print(definition.value, Level::expression);
        out += '\n';
    }

    /// In brackets if it is one of these names, which mean something else where they stand.
    void print_name_apart(ExpressionId id, Level least,
                          std::initializer_list<std::string_view> words) {
        const std::size_t begin = out.size();
        print(id, least);
        if (std::ranges::find(words, std::string_view(out).substr(begin)) != words.end()) {
            bracket(begin);
        }
    }
    void print_initial(const ParameterDeclaration& parameter) {
        const auto number = [&] { return std::get<Number>(program[parameter.initial].node).value; };
        switch (parameter.type) {
            case ParameterType::choice:
                print_text("", parameter.choices.at(static_cast<std::size_t>(number())));
                return;
            case ParameterType::toggle:
                out += number() == 0 ? " off" : " on";
                return;
            case ParameterType::real:
            case ParameterType::integer:
            case ParameterType::logarithmic:
            case ParameterType::angle:
            case ParameterType::colour:
                out += ' ';
                print_name_apart(parameter.initial, Level::sum, {"on", "off"});
                return;
        }
    }
    void print_text(std::string_view word, const std::optional<std::string>& text) {
        if (!text) return;
        out += word;
        fmt::format_to(std::back_inserter(out), " \"{}\"", *text);
    }
    void print_values(const ParameterDeclaration& parameter) {
        if (!parameter.choices.empty()) {
            fmt::format_to(std::back_inserter(out), " in [\"{}\"]",
                           fmt::join(parameter.choices, "\", \""));
        } else if (parameter.range) {
            out += " in [";
            print((*parameter.range)[0], Level::sum);
            out += ", ";
            print((*parameter.range)[1], Level::sum);
            out += ']';
        }
    }
    void print_type(ParameterType type) {
        switch (type) {
            case ParameterType::real:
            case ParameterType::choice:
            case ParameterType::toggle:
                return;
            case ParameterType::integer:
            case ParameterType::logarithmic:
            case ParameterType::angle:
            case ParameterType::colour:
                out += ' ';
                out += spelling(type);
                return;
        }
    }
    void operator()(const ParameterDeclaration& parameter) {
        fmt::format_to(std::back_inserter(out), "param {} =", parameter.name);
        print_initial(parameter);
        print_values(parameter);
        print_type(parameter.type);
        if (parameter.step) {
            out += " step ";
            const std::size_t begin = out.size();
            print(*parameter.step, Level::sum);
            if (out[begin] == '(') out.insert(begin, "+");  // `step (` would be the function
        }
        print_text("", parameter.label);
        print_text(" group", parameter.group);
        print_text(" tooltip", parameter.tooltip);
        out += '\n';
    }
};

}  // namespace

std::string print_formula(const Program& program) {
    Printer printer{program};
    for (const Statement& statement : program.statements) std::visit(printer, statement);
    printer.print_name_apart(program.result, Level::expression, {"param"});
    return std::move(printer.out) + '\n';
}

}  // namespace formula
