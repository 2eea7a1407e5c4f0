// SPDX-License-Identifier: MIT
// The gradients of objects: exact for formulas and for iterations that carry them, by differences
// for other iterations and blends.
#include <fmt/format.h>

#include "shader/field_code.h"

namespace shader {
namespace {

/// What tells the objects of a blend.
std::string condition(const FieldCode& code, const OuterBlend& blend) {
    const std::size_t last = blend.first_object + leaves(code.field, blend.id).size() - 1;
    return fmt::format("object >= {} && object <= {}", blend.first_object, last);
}

/// A gradient within cells, taken back out of them.
std::string exact_gradient(const FieldCode& code, const std::string& condition,
                           const std::vector<field::FieldId>& cells, const std::string& gradient) {
    const WayIn way = way_in(code, cells, "        ");
    std::string text = fmt::format("    if ({}) {{\n{}", condition, way.statements);
    text += fmt::format("        {}\n", fmt::format(fmt::runtime(gradient), way.points.back()));
    for (std::size_t k = cells.size(); k-- > 0;) {
        text += fmt::format("        g = cell_back_{}({}, g);\n", code.plan.cells_number(cells[k]),
                            way.points[k]);
    }
    return text + "    }\n";
}

std::string value_inside(const FieldCode& code, const std::string& condition,
                         const std::vector<field::FieldId>& cells, const std::string& value) {
    const WayIn way = way_in(code, cells, "        ");
    return fmt::format("    if ({}) {{\n{}        {}\n    }}\n", condition, way.statements,
                       fmt::format(fmt::runtime(value), way.points.back()));
}

}  // namespace

void write_gradients(FieldCode& code) {
    std::string distances, gradients, by_differences;
    const auto add_difference = [&](const std::string& objects) {
        by_differences += fmt::format("{}({})", by_differences.empty() ? "" : " || ", objects);
    };
    for (std::size_t i = 0; i < code.plan.objects.size(); ++i) {
        const Object& object = code.plan.objects[i];
        if (object.blend || object.is_member) continue;
        const std::string is_this = fmt::format("object == {}", i);
        if (code.formula(i)) {
            gradients +=
                exact_gradient(code, is_this, object.cells, fmt::format("value_{}({{}}, g);", i));
        } else if (code.orbit_gradients.contains(object.id)) {
            gradients += exact_gradient(code, is_this, object.cells,
                                        fmt::format("g = gradient_{}({{}});", i));
        } else {
            distances += value_inside(
                code, is_this, object.cells,
                fmt::format("bool inside;\n        return value_{}({{}}, inside);", i));
            add_difference(is_this);
        }
    }
    for (std::size_t i = 0; i < code.plan.families.size(); ++i) {
        const CodedFamily& family = code.families[i];
        gradients += exact_gradient(
            code,
            fmt::format("object >= {} && object <= {}", family.first_object, family.last_object()),
            family.cells,
            fmt::format("g = member_gradient_{}({{}}, {});", i, family.row("object")));
    }
    for (std::size_t i = 0; i < code.plan.blends.size(); ++i) {
        const OuterBlend& blend = code.plan.blends[i];
        const std::string objects = condition(code, blend);
        if (blend.iterates) {
            distances += value_inside(code, objects, blend.cells,
                                      fmt::format("real slope;\n        int nearest;\n        "
                                                  "return blend_{}({{}}, real3(0.0), slope, "
                                                  "nearest);",
                                                  i));
            add_difference(objects);
        } else {
            gradients += exact_gradient(code, objects, blend.cells,
                                        fmt::format("g = blend_gradient_{}({{}});", i));
        }
    }
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
