// SPDX-License-Identifier: MIT
#include "field/parameter.h"

namespace field {

std::string component_name(const Parameter& parameter, std::size_t component) {
    if (parameter.size() == 1) return parameter.name;
    return parameter.name + '.' + "xyzw"[component];
}

}  // namespace field
