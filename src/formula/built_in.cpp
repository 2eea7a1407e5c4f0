// SPDX-License-Identifier: MIT
#include "formula/built_in.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "formula/combinations.h"
#include "formula/functions.h"
#include "formula/prelude.h"
#include "formula/user_function.h"
#include "formula/vector_functions.h"

namespace formula {
namespace {

std::string initial_text(const std::vector<double>& components) {
    if (components.size() == 1) return fmt::format("{}", components[0]);
    return fmt::format("({})", fmt::join(components, ", "));
}

}  // namespace

bool is_coordinate(std::string_view name) { return name == "x" || name == "y" || name == "z"; }

bool is_callable(std::string_view name) {
    return name == "if" || find_function(name) || find_vector_function(name) ||
           find_combination(name) || field::find_primitive(name) || is_in_prelude(name);
}

std::string signature(const field::Primitive& primitive) {
    std::string text(primitive.name);
    text += '(';
    for (const field::Argument& argument : primitive.arguments) {
        if (&argument != &primitive.arguments.front()) text += ", ";
        text += argument.name;
        if (!argument.required) text += " = " + initial_text(argument.initial);
    }
    return text + ')';
}

std::string signature(std::string_view callable) {
    if (const Function* function = find_function(callable)) return std::string(function->signature);
    if (const VectorFunction* it = find_vector_function(callable)) {
        return std::string(it->signature);
    }
    if (callable == "if") return "if(a < b, u, v)";
    if (const Combination* it = find_combination(callable)) return std::string(it->signature);
    if (is_in_prelude(callable)) return signature(prelude_function(callable));
    const field::Primitive* primitive = field::find_primitive(callable);
    assert(primitive);
    return signature(*primitive);
}

std::vector<std::string_view> built_in_names() {
    std::vector<std::string_view> names{"x", "y", "z", "r", "t", "e", "pi", "tau", "if"};
    for (const Function& it : functions()) names.push_back(it.name);
    for (const VectorFunction& it : vector_functions()) names.push_back(it.name);
    for (const Combination& it : combinations()) names.push_back(it.name);
    for (const field::Primitive& it : field::primitives()) names.push_back(it.name);
    names.insert(names.end(), prelude_names().begin(), prelude_names().end());
    std::ranges::sort(names);
    return names;
}

}  // namespace formula
