// SPDX-License-Identifier: MIT
// The own colours of objects.
#include <fmt/format.h>

#include "shader/field_code.h"
#include "shader/iteration_glsl.h"

namespace shader {
namespace {

void write_colour(FieldCode& code, const std::string& name, const field::Colour& colour,
                  const field::Iteration* iteration) {
    ExpressionWriter w = code.writer();
    const std::string body = iteration
                                 ? iteration_colour(code.field.graph, *iteration, w, code.values)
                                 : w.statements(colour, "    ");
    code.out.code += fmt::format("real3 {}(real3 p) {{\n{}", name, body);
    code.out.code += fmt::format("    return real3({}, {}, {});\n}}\n", w.spelling(colour[0]),
                                 w.spelling(colour[1]), w.spelling(colour[2]));
    code.finish(w);
}

/// A colour, and the cells into whose coordinates it belongs: that of the outermost cells that have
/// one, else the leaf's.
struct OwnColour {
    field::Colour colour{};
    std::vector<field::FieldId> cells;
    const field::Iteration* iteration = nullptr;
};

std::optional<OwnColour> colour_of_cells(const FieldCode& code,
                                         const std::vector<field::FieldId>& around) {
    for (auto cells = around.begin(); cells != around.end(); ++cells) {
        const auto& colour = std::get<field::Cells>(code.field[*cells]).colour;
        if (colour) return OwnColour{*colour, {around.begin(), cells}};
    }
    return std::nullopt;
}

std::optional<OwnColour> own_colour(const FieldCode& code, std::size_t i) {
    const Object& object = code.plan.objects[i];
    if (auto own = colour_of_cells(code, object.cells)) return own;
    const auto colour = colour_of(code.field[object.id]);
    if (!colour) return std::nullopt;
    return OwnColour{*colour, object.cells, code.iteration(i)};
}

/// What tells the colours of a family's members.
std::string family_colour(FieldCode& code, std::size_t i) {
    const CodedFamily& family = code.families[i];
    const std::optional<OwnColour> own = colour_of_cells(code, family.cells);
    if (!own && !family.has_colours()) return {};
    const std::string name = fmt::format("colour_of_family_{}", i);
    if (own) write_colour(code, name, own->colour, nullptr);
    const WayIn way = way_in(code, own ? own->cells : family.cells, "        ");
    const std::string& p = way.points.back();
    const std::string answer =
        own ? fmt::format("        colour = {}({});\n        return true;\n", name, p)
            : fmt::format(
                  "        real4 own = member_colour_{}({}, {});\n"
                  "        colour = own.rgb;\n        return own.a > 0.0;\n",
                  i, p, family.row("object"));
    return fmt::format("    if (object >= {} && object <= {}) {{\n{}{}    }}\n",
                       family.first_object, family.last_object(), way.statements, answer);
}

}  // namespace

void write_colours(FieldCode& code) {
    std::string calls;
    for (std::size_t i = 0; i < code.plan.objects.size(); ++i) {
        if (code.plan.objects[i].is_member) continue;
        const std::optional<OwnColour> own = own_colour(code, i);
        if (!own) continue;
        write_colour(code, fmt::format("colour_{}", i), own->colour, own->iteration);
        const WayIn way = way_in(code, own->cells, "        ");
        calls += fmt::format(
            "    if (object == {0}) {{\n{1}        colour = colour_{0}({2});\n"
            "        return true;\n    }}\n",
            i, way.statements, way.points.back());
    }
    for (std::size_t i = 0; i < code.plan.families.size(); ++i) calls += family_colour(code, i);
    code.out.has_colours = !calls.empty();
    if (!code.out.has_colours) return;
    code.out.code += fmt::format(
        "bool object_colour(int object, real3 p, out real3 colour) {{\n{}"
        "    return false;\n}}\n",
        calls);
}

}  // namespace shader
