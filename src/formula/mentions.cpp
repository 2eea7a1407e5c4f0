// SPDX-License-Identifier: MIT
#include "formula/mentions.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace formula {
namespace {

/// The value of an argument by name: the right side of `a = 1`.
std::optional<ExpressionId> value_of_named(const Program& program, ExpressionId argument) {
    const auto* comparison = std::get_if<Comparison>(&program[argument].node);
    if (!comparison || comparison->relation != Relation::equal) return std::nullopt;
    const auto* name = std::get_if<Name>(&program[comparison->left].node);
    if (!name || name->text == "x" || name->text == "y" || name->text == "z") return std::nullopt;
    return comparison->right;
}

/// What a statement needs; of a function its parameters are no names of others.
Mentions needs(const Program& program, const Statement& statement) {
    const auto* definition = std::get_if<Definition>(&statement);
    if (!definition) return {};
    Mentions names = mentions(program, definition->value);
    if (definition->parameters) {
        for (const FunctionParameter& it : *definition->parameters) names.erase(it.name);
    }
    return names;
}

const std::string& name_of(const Statement& statement) {
    return std::visit([](const auto& it) -> const std::string& { return it.name; }, statement);
}

}  // namespace

Mentions mentions(const Program& program, ExpressionId id) {
    Mentions names;
    std::vector<ExpressionId> open{id};
    while (!open.empty()) {
        const ExpressionNode& node = program[open.back()].node;
        open.pop_back();
        if (const auto* name = std::get_if<Name>(&node)) names.insert(name->text);
        if (const auto* call = std::get_if<Call>(&node)) {
            names.insert(call->function);
            for (const ExpressionId argument : call->arguments) {
                open.push_back(value_of_named(program, argument).value_or(argument));
            }
            continue;
        }
        for (const ExpressionId part : parts(node)) open.push_back(part);
    }
    return names;
}

std::vector<std::string_view> cycle(const Program& program, std::size_t from,
                                    std::string_view next) {
    const std::string_view target = name_of(program.statements[from]);
    const auto statement_of = [&](std::string_view name) -> const Statement* {
        const auto found = std::ranges::find_if(
            program.statements, [&](const Statement& it) { return name_of(it) == name; });
        return found == program.statements.end() ? nullptr : &*found;
    };
    // Depth first; `path` holds each definition with those that it still leads to.
    std::vector<std::pair<std::string_view, Mentions>> path;
    Mentions seen;
    path.push_back({target, {next}});
    while (!path.empty()) {
        Mentions& left = path.back().second;
        if (left.empty()) {
            path.pop_back();
            continue;
        }
        const std::string_view name = *left.begin();
        left.erase(left.begin());
        if (name == target) {
            std::vector<std::string_view> names;
            for (const auto& [step, rest] : path) names.push_back(step);
            names.push_back(target);
            return names;
        }
        const Statement* statement = statement_of(name);
        if (statement && seen.insert(name).second)
            path.push_back({name, needs(program, *statement)});
    }
    return {};
}

}  // namespace formula
