// SPDX-License-Identifier: MIT
// Whether a formula's value is told apart from 0.
#include <fmt/format.h>

#include "shader/field_code.h"

namespace shader {
void write_rounding(FieldCode& code) {
    std::string objects;
    for (std::size_t i = 0; i < code.plan.objects.size(); ++i) {
        const Object& object = code.plan.objects[i];
        const auto error = code.rounding.find(object.id);
        if (object.is_member || error == code.rounding.end()) continue;
        ExpressionWriter w = code.writer();
        w.name(code.position_error, "off");
        const std::array roots{code.formula(i)->value, error->second};
        code.out.code += fmt::format("bool is_zero_{}(real3 p, real off) {{\n{}", i,
                                     w.statements(roots, "    "));
        code.out.code += fmt::format("    return abs({}) <= {};\n}}\n", w.spelling(roots[0]),
                                     w.spelling(roots[1]));
        code.finish(w);
        const WayIn way = way_in(code, object.cells, "        ");
        objects +=
            fmt::format("    if (object == {}) {{\n{}        return is_zero_{}({}, off);\n    }}\n",
                        i, way.statements, i, way.points.back());
    }
    code.out.code += fmt::format(
        "bool object_is_zero(int object, real3 p, real off) {{\n{}    return true;\n}}\n", objects);
}

}  // namespace shader
