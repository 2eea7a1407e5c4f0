// SPDX-License-Identifier: MIT
#include "formula/scope.h"

#include <utility>

namespace formula {

Binding& Scope::set(std::string_view name, Value value, base::SourceSpan span, Role role) {
    const std::size_t order = names.size();
    const auto [place, is_new] = names.try_emplace(std::string(name));
    Binding& binding = place->second;
    if (is_new) binding = {Nothing{}, span, role, false, order};
    binding.value = std::move(value);
    return binding;
}

Binding* find_binding(Scope* scope, std::string_view name) {
    std::size_t visible = all_names;
    for (; scope; visible = scope->visible, scope = scope->outer) {
        const auto found = scope->names.find(name);
        if (found != scope->names.end() && found->second.order < visible) return &found->second;
    }
    return nullptr;
}

}  // namespace formula
