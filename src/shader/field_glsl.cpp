// SPDX-License-Identifier: MIT
#include "shader/field_glsl.h"

#include <utility>

#include <fmt/format.h>

#include "shader/field_code.h"

namespace shader {
FieldGlsl field_glsl(field::Field field, bool count_evaluations, const Demands& demands) {
    FieldCode code(std::move(field), demands);
    code.out.code += fmt::format("const bool zs_has_edges = {};\n", code.edges);
    write_leaves(code);
    write_cells(code);
    write_blends(code);
    write_tree(code, count_evaluations);
    if (code.demands.intervals) write_enclosures(code, count_evaluations);
    write_gradients(code);
    write_colours(code);
    code.out.has_edges = code.edges;
    code.out.values = code.values.list();
    code.out.expressions = eval::make_tape(code.field.graph, code.values.expressions());
    return std::move(code.out);
}

}  // namespace shader
