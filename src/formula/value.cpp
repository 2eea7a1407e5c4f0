// SPDX-License-Identifier: MIT
#include "formula/value.h"

#include <fmt/format.h>

namespace formula {
namespace {

struct Words {
    std::string operator()(const Nothing&) const { return "nothing"; }
    std::string operator()(graph::NodeId) const { return "a number"; }
    std::string operator()(const VectorValue& vector) const {
        switch (vector.algebra) {
            case Algebra::vector:
                return fmt::format("a vector of {}", vector.components.size());
            case Algebra::complex:
                return "a complex number";
            case Algebra::quaternion:
                return "a quaternion";
            case Algebra::triplex:
                return "a triplex number";
        }
        return "";
    }
    std::string operator()(const FieldValue&) const { return "a field"; }
    std::string operator()(const FunctionValue&) const { return "a function"; }
};

}  // namespace

std::string describe(const Value& value) { return std::visit(Words{}, value); }

}  // namespace formula
