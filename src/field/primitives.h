// SPDX-License-Identifier: MIT
// The built-in solids: one table with names, arguments, defaults and builders.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "field/field.h"

namespace field {

/// One argument of a primitive. An argument of more than one component is a tuple in the language.
struct Argument {
    std::string_view name;
    std::vector<double> initial;  ///< one number per component
    bool required = false;        ///< if so, `initial` only gives the number of components
};

/// A built-in field. `build` gets the components of all arguments in a row, in the table's order,
/// as nodes that do not depend on the point.
struct Primitive {
    std::string_view name;
    std::vector<Argument> arguments;
    std::string_view summary;  ///< one sentence for help and documents
    FieldId (*build)(Field&, std::span<const graph::NodeId>);
};

/// All of them, sorted by name.
std::span<const Primitive> primitives();
const Primitive* find_primitive(std::string_view name);

}  // namespace field
