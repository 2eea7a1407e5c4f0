// SPDX-License-Identifier: MIT
// Names and what they stand for, scope within scope. Internal to the library.
#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <string_view>

#include "base/source_span.h"
#include "formula/value.h"

namespace formula {

/// Who gave a name its meaning.
enum class Role {
    definition,
    slider,    ///< `param`
    argument,  ///< of a function, inside of it
    state,     ///< of an iteration, or a name of one turn
};

/// A name that the text defines.
struct Binding {
    Value value;
    base::SourceSpan span;  ///< of the name where it is defined
    Role role = Role::definition;
    bool used = false;
    std::size_t order = 0;  ///< how many names the scope had before
};

inline constexpr std::size_t all_names = std::numeric_limits<std::size_t>::max();

/// The names of the whole text, of a function's body, or of an iteration. Inner ones hide outer
/// ones, and all hide what is built in. Of the scope around it only the first `visible` names are
/// seen: a function knows what was defined above it, also when it is called from further down.
struct Scope {
    Scope* outer = nullptr;
    std::size_t visible = all_names;
    std::map<std::string, Binding, std::less<>> names{};
    const Iterate* iteration = nullptr;  ///< whose names these are

    /// Gives a name a meaning, or another one: then it keeps its place and whether it was used.
    Binding& set(std::string_view name, Value value, base::SourceSpan span, Role role);
};

/// The binding of a name as it is seen from a scope, the innermost first; null if none has it.
Binding* find_binding(Scope* scope, std::string_view name);

}  // namespace formula
