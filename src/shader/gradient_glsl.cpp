// SPDX-License-Identifier: MIT
// The gradients of objects: exact for formulas, by differences for iterations and blends.
#include <fmt/format.h>

#include "shader/field_code.h"

namespace shader {
namespace {

/// The gradient of a formula, taken back out of the cells around it.
std::string exact_gradient(const FieldCode& code, std::size_t i) {
    const Object& object = code.plan.objects[i];
    if (object.cells.empty()) return fmt::format("    if (object == {0}) value_{0}(p, g);\n", i);
    const WayIn way = way_in(code, object.cells, "        ");
    std::string text = fmt::format("    if (object == {}) {{\n{}", i, way.statements);
    text += fmt::format("        value_{}({}, g);\n", i, way.points.back());
    for (std::size_t k = object.cells.size(); k-- > 0;) {
        text += fmt::format("        g = cell_back_{}({}, g);\n",
                            code.plan.cells_number(object.cells[k]), way.points[k]);
    }
    return text + "    }\n";
}

std::string iteration_value(const FieldCode& code, std::size_t i) {
    const Object& object = code.plan.objects[i];
    const WayIn way = way_in(code, object.cells, "        ");
    return fmt::format(
        "    if (object == {0}) {{\n{1}        bool inside;\n"
        "        return value_{0}({2}, inside);\n    }}\n",
        i, way.statements, way.points.back());
}

std::string blend_value(const FieldCode& code, std::size_t i) {
    const OuterBlend& blend = code.plan.blends[i];
    const std::size_t last = blend.first_object + leaves(code.field, blend.id).size() - 1;
    const WayIn way = way_in(code, blend.cells, "        ");
    return fmt::format(
        "    if (object >= {} && object <= {}) {{\n{}        int nearest;\n"
        "        return blend_{}({}, real3(0.0), nearest);\n    }}\n",
        blend.first_object, last, way.statements, i, way.points.back());
}

}  // namespace

void write_gradients(FieldCode& code) {
    std::string distances, gradients, by_differences;
    for (std::size_t i = 0; i < code.plan.objects.size(); ++i) {
        const bool blended = code.plan.objects[i].blend.has_value();
        if (code.formula(i) && !blended) {
            gradients += exact_gradient(code, i);
            continue;
        }
        if (!blended) distances += iteration_value(code, i);
        by_differences += fmt::format("{}object == {}", by_differences.empty() ? "" : " || ", i);
    }
    for (std::size_t i = 0; i < code.plan.blends.size(); ++i) distances += blend_value(code, i);
    if (!distances.empty()) {
        code.out.needs_differences = true;
        code.out.code += fmt::format(
            "real object_distance(int object, real3 p) {{\n{}    return 0.0;\n}}\n", distances);
        code.out.code += "real3 object_differences(int object, real3 p, real h);\n";
        gradients +=
            fmt::format("    if ({}) g = object_differences(object, p, h);\n", by_differences);
    }
    code.out.code += fmt::format(
        "real3 object_gradient(int object, real3 p, real h) {{\n"
        "    real3 g = real3(0.0);\n"
        "{}    return g;\n"
        "}}\n",
        gradients);
}

}  // namespace shader
