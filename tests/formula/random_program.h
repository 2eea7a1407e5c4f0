// SPDX-License-Identifier: MIT
// Syntax trees of all kinds, as a row of random numbers says. A shorter row or smaller numbers give
// a simpler tree, so that a counterexample can be made small.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "formula/ast.h"
#include "formula/words.h"

namespace formula {

class RandomProgram {
public:
    explicit RandomProgram(std::vector<std::uint16_t> row) : row_(std::move(row)) {}

    /// A program that has a text: its keywords are no names where they are keywords.
    Program program() {
        for (unsigned n = next(5); n > 0; --n) {
            if (next(3) == 2) {
                program_.statements.push_back(parameter());
            } else {
                program_.statements.push_back(definition());
            }
        }
        program_.result = value();
        return std::move(program_);
    }

private:
    /// A number below `count`; 0 when the row has ended.
    unsigned next(unsigned count) { return at_ < row_.size() ? row_[at_++] % count : 0; }

    ExpressionId add(ExpressionNode node) { return program_.add(std::move(node), {}); }

    std::string name() {
        static constexpr const char* names[] = {
            "x",       "y",      "a",        "q",     "e",       "e1",      "E2x",
            "ex",      "pi",     "x2",       "_",     "param",   "on",      "off",
            "angle",   "colour", "distance", "group", "integer", "iterate", "intger",
            "tooltip", "in",     "step",     "for",   "until"};
        while (true) {
            const std::string text = names[next(std::size(names))];
            if (is_name(within_, text, false)) return text;
        }
    }

    /// A name that is not there yet and not given by the body of an iteration.
    std::string new_name(std::vector<std::string>& taken) {
        std::string text = name();
        while (std::ranges::find(taken, text) != taken.end() || text == "distance" ||
               text == "colour") {
            text += 'a';
        }
        taken.push_back(text);
        return text;
    }

    std::string label() {
        static constexpr const char* labels[] = {"a", "", "# (b", "in [0, 1]", "\xC3\xBC;"};
        return labels[next(std::size(labels))];
    }

    double number() {
        static constexpr double numbers[] = {
            1, 0, 2, 0.5, 10, 1e20, 1e-7, 0.1, 1.7976931348623157e308, 5e-324};
        const unsigned choice = next(std::size(numbers) + 1);
        if (choice < std::size(numbers)) return numbers[choice];
        std::uint64_t bits = 0;
        for (int i = 0; i < 4; ++i) bits = bits << 16 | next(65536);
        const double value = std::abs(std::bit_cast<double>(bits));
        return std::isfinite(value) ? value : 3;
    }

    std::vector<ExpressionId> list(unsigned least) {
        std::vector<ExpressionId> parts;
        for (unsigned n = least + next(3); n > 0; --n) parts.push_back(expression());
        return parts;
    }

    std::vector<Operand> chain(Joint first, std::vector<Joint> joints) {
        std::vector<Operand> operands{{first, expression()}};
        for (unsigned n = 1 + next(3); n > 0; --n) {
            const Joint joint = joints[next(static_cast<unsigned>(joints.size()))];
            operands.push_back({joint, expression()});
        }
        return operands;
    }

    ExpressionId comparison() {
        const auto relation = static_cast<Relation>(next(5));
        const ExpressionId left = expression();
        return add(Comparison{relation, left, expression()});
    }

    ExpressionId condition() {
        switch (next(3)) {
            case 0:
                return comparison();
            case 1:
                return add(Intersection{chain(Joint::both, {Joint::both, Joint::without})});
            default:
                return add(Union{chain(Joint::either, {Joint::either})});
        }
    }

    ExpressionId component() {
        std::string letters;
        for (unsigned n = 1 + next(4); n > 0; --n) letters += "xyzw"[next(4)];
        return add(Component{expression(), letters, {}});
    }

    ExpressionId power() {
        const ExpressionId base = expression();
        return add(Power{base, expression()});
    }

    ExpressionId expression() {
        if (depth_ == max_depth || at_ >= row_.size()) return add(Name{name()});
        ++depth_;
        const ExpressionId id = branch();
        --depth_;
        return id;
    }

    ExpressionId branch() {
        switch (next(14)) {
            case 0:
            case 1:
                return add(Name{name()});
            case 2:
            case 3:
                return add(Number{number()});
            case 4:
                return add(Negate{expression()});
            case 5:
                return power();
            case 6:
                return add(Sum{chain(Joint::plus, {Joint::plus, Joint::minus})});
            case 7:
            case 8:
                return add(Product{
                    chain(Joint::times, {Joint::times, Joint::over, Joint::implied_times})});
            case 9:
                return add(Intersection{chain(Joint::both, {Joint::both, Joint::without})});
            case 10:
                return add(Union{chain(Joint::either, {Joint::either})});
            case 11:
                return comparison();
            case 12:
                return add(Call{name(), {}, list(0)});
            default:
                return next(2) == 0 ? component() : add(Tuple{list(2)});
        }
    }

    ExpressionId iterate() {
        Iterate it;
        std::vector<std::string> taken;
        within_ = Within::iteration;
        for (unsigned n = 1 + next(3); n > 0; --n) {
            std::string state = new_name(taken);
            it.state.push_back({std::move(state), {}, expression()});
        }
        it.limit = expression();
        if (next(2) == 1) it.until = condition();
        within_ = Within::statement;
        for (unsigned n = 1 + next(3); n > 0; --n) {
            std::vector<std::string> any;
            std::string set = new_name(any);
            it.body.push_back({std::move(set), {}, expression()});
        }
        if (next(3) == 1) it.distance = expression();
        if (next(3) == 1) it.colour = expression();
        return add(std::move(it));
    }

    ExpressionId value() { return next(4) == 3 ? iterate() : expression(); }

    Definition definition() {
        Definition definition{name(), {}, {}, std::nullopt};
        if (next(2) == 1) {
            definition.parameters.emplace();
            std::vector<std::string> taken;
            for (unsigned n = 1 + next(3); n > 0; --n) {
                FunctionParameter parameter{new_name(taken), {}, std::nullopt};
                if (next(2) == 1) parameter.initial = expression();
                definition.parameters->push_back(std::move(parameter));
            }
        }
        definition.value = value();
        return definition;
    }

    ParameterDeclaration parameter() {
        within_ = Within::parameter;
        ParameterDeclaration it;
        it.name = name();
        it.type = static_cast<ParameterType>(next(7));
        if (it.type == ParameterType::choice) {
            it.choices = {"round", "a # (b", "a"};
            it.choices.resize(1 + next(3));
            it.initial =
                add(Number{static_cast<double>(next(static_cast<unsigned>(it.choices.size())))});
        } else if (it.type == ParameterType::toggle) {
            it.initial = add(Number{static_cast<double>(next(2))});
        } else {
            it.initial = expression();
            if (next(2) == 1) it.range = {expression(), expression()};
            if (next(3) == 1) it.step = expression();
        }
        if (next(2) == 1) it.label = label();
        if (next(3) == 1) it.group = label();
        if (next(3) == 1) it.tooltip = label();
        within_ = Within::statement;
        return it;
    }

    static constexpr unsigned max_depth = 7;
    std::vector<std::uint16_t> row_;
    std::size_t at_ = 0;
    unsigned depth_ = 0;
    Within within_ = Within::statement;
    Program program_;
};

}  // namespace formula
