// SPDX-License-Identifier: MIT
#include "formula/print_ast.h"

#include <fmt/format.h>

#include <string_view>

namespace formula {
namespace {

std::string_view mark(Joint joint) {
    switch (joint) {
        case Joint::plus:
            return "+ ";
        case Joint::minus:
            return "- ";
        case Joint::times:
            return "* ";
        case Joint::over:
            return "/ ";
        case Joint::implied_times:
            return ". ";
        case Joint::both:
            return "& ";
        case Joint::without:
            return "\\ ";
        case Joint::either:
            return "| ";
    }
    return "";
}

/// The line of one node, without its parts.
struct Head {
    std::string operator()(const Number& number) const { return fmt::format("{}", number.value); }
    std::string operator()(const Name& name) const { return name.text; }
    std::string operator()(const Negate&) const { return "negate"; }
    std::string operator()(const Sum&) const { return "sum"; }
    std::string operator()(const Product&) const { return "product"; }
    std::string operator()(const Intersection&) const { return "intersection"; }
    std::string operator()(const Union&) const { return "union"; }
    std::string operator()(const Power&) const { return "power"; }
    std::string operator()(const Comparison& comparison) const {
        return fmt::format("compare {}", spelling(comparison.relation));
    }
    std::string operator()(const Call& call) const { return "call " + call.function; }
    std::string operator()(const Tuple&) const { return "tuple"; }
    std::string operator()(const Component& component) const {
        return "component " + component.letters;
    }
    std::string operator()(const Iterate&) const { return "iterate"; }
    std::string operator()(const Broken&) const { return "broken"; }
};

const std::vector<Operand>* operands(const ExpressionNode& node) {
    if (const auto* sum = std::get_if<Sum>(&node)) return &sum->operands;
    if (const auto* product = std::get_if<Product>(&node)) return &product->operands;
    if (const auto* chain = std::get_if<Intersection>(&node)) return &chain->operands;
    if (const auto* chain = std::get_if<Union>(&node)) return &chain->operands;
    return nullptr;
}

void print(const Program& program, ExpressionId id, std::size_t depth, std::string_view prefix,
           std::string& out);

/// A heading, and the expression below it.
void print_part(const Program& program, ExpressionId id, std::size_t depth,
                std::string_view heading, std::string& out) {
    out.append(2 * depth, ' ');
    out += heading;
    out += '\n';
    print(program, id, depth + 1, "", out);
}

void print_parts(const Program& program, const Iterate& iterate, std::size_t depth,
                 std::string& out) {
    for (const Assignment& it : iterate.state) {
        print_part(program, it.value, depth, "state " + it.name, out);
    }
    print_part(program, iterate.limit, depth, "for", out);
    if (iterate.until) print_part(program, *iterate.until, depth, "until", out);
    for (const Assignment& it : iterate.body) {
        print_part(program, it.value, depth, "set " + it.name, out);
    }
    if (iterate.distance) print_part(program, *iterate.distance, depth, "distance", out);
    if (iterate.colour) print_part(program, *iterate.colour, depth, "colour", out);
}

void print(const Program& program, ExpressionId id, std::size_t depth, std::string_view prefix,
           std::string& out) {
    const ExpressionNode& node = program[id].node;
    out.append(2 * depth, ' ');
    out += prefix;
    out += std::visit(Head{}, node);
    out += '\n';
    if (const auto* chain = operands(node)) {
        for (const Operand& operand : *chain) {
            print(program, operand.expression, depth + 1, mark(operand.joint), out);
        }
        return;
    }
    if (const auto* iterate = std::get_if<Iterate>(&node)) {
        print_parts(program, *iterate, depth + 1, out);
        return;
    }
    for (const ExpressionId part : parts(node)) print(program, part, depth + 1, "", out);
}

void print_text(std::string_view heading, const std::optional<std::string>& text,
                std::string& out) {
    if (text) out += fmt::format("  {} \"{}\"\n", heading, *text);
}

void print(const Program& program, const ParameterDeclaration& parameter, std::string& out) {
    out += fmt::format("param {}\n", parameter.name);
    if (parameter.type != ParameterType::real) {
        out += fmt::format("  type {}\n", spelling(parameter.type));
    }
    print_part(program, parameter.initial, 1, "initial", out);
    for (const std::string& it : parameter.choices) print_text("choice", it, out);
    if (parameter.range) {
        out += "  range\n";
        for (const ExpressionId end : *parameter.range) print(program, end, 2, "", out);
    }
    if (parameter.step) print_part(program, *parameter.step, 1, "step", out);
    print_text("label", parameter.label, out);
    print_text("group", parameter.group, out);
    print_text("tooltip", parameter.tooltip, out);
}

void print(const Program& program, const Definition& definition, std::string& out) {
    out += fmt::format("define {}\n", definition.name);
    if (!definition.parameters) {
        print(program, definition.value, 1, "", out);
        return;
    }
    for (const FunctionParameter& it : *definition.parameters) {
        out += fmt::format("  parameter {}\n", it.name);
        if (it.initial) print(program, *it.initial, 2, "", out);
    }
    print_part(program, definition.value, 1, "value", out);
}

}  // namespace

std::string print_ast(const Program& program) {
    std::string out;
    for (const Statement& statement : program.statements) {
        std::visit([&](const auto& it) { print(program, it, out); }, statement);
    }
    out += "formula\n";
    print(program, program.result, 1, "", out);
    return out;
}

std::string print_ast(const Program& program, ExpressionId id) {
    std::string out;
    print(program, id, 0, "", out);
    return out;
}

}  // namespace formula
