// SPDX-License-Identifier: MIT
// The functions of cells.
#include <fmt/format.h>

#include "shader/field_code.h"

namespace shader {
namespace {

using graph::NodeId;

/// The scalar product of known coefficients with a vector, without what is 0.
std::string product(const FieldCode& code, ExpressionWriter& w, const Gradient& coefficients,
                    const std::string& vector) {
    std::string text;
    for (std::size_t i = 0; i < 3; ++i) {
        if (code.field.graph.is_constant(coefficients[i], 0)) continue;
        const std::string component = fmt::format("{}.{}", vector, "xyz"[i]);
        if (!text.empty()) text += " + ";
        text += code.field.graph.is_constant(coefficients[i], 1)
                    ? component
                    : fmt::format("{} * {}", w.spelling(coefficients[i]), component);
    }
    return text.empty() ? "0.0" : text;
}

void write_way_in(FieldCode& code, std::size_t i, const field::Cells& cells) {
    const field::FieldId id = code.plan.cells[i];
    const auto& turn = code.turns.at(id);
    const std::vector<Gradient>& rates = code.wall_rates.at(id);
    std::vector<NodeId> roots(cells.point.begin(), cells.point.end());
    for (const Gradient& row : turn) roots.insert(roots.end(), row.begin(), row.end());
    roots.insert(roots.end(), cells.walls.begin(), cells.walls.end());
    for (const Gradient& rate : rates) roots.insert(roots.end(), rate.begin(), rate.end());
    ExpressionWriter w = code.writer();
    std::string& text = code.out.code;
    text += fmt::format(
        "void cell_{}(real3 p, real3 d, out real3 q, out real3 e, out real wall) {{\n", i);
    text += w.statements(roots, "    ");
    text += fmt::format("    q = real3({}, {}, {});\n", w.spelling(cells.point[0]),
                        w.spelling(cells.point[1]), w.spelling(cells.point[2]));
    text += fmt::format("    e = real3({}, {}, {});\n", product(code, w, turn[0], "d"),
                        product(code, w, turn[1], "d"), product(code, w, turn[2], "d"));
    text += "    wall = zs_far;\n";
    for (std::size_t k = 0; k < rates.size(); ++k) {
        text += fmt::format("    wall = min(wall, cell_exit({}, {}));\n",
                            w.spelling(cells.walls[k]), product(code, w, rates[k], "d"));
    }
    text += "}\n";
    code.finish(w);
}

void write_way_back(FieldCode& code, std::size_t i) {
    const auto& turn = code.turns.at(code.plan.cells[i]);
    std::vector<NodeId> roots;
    for (const Gradient& row : turn) roots.insert(roots.end(), row.begin(), row.end());
    ExpressionWriter w = code.writer();
    const auto column = [&](std::size_t k) { return Gradient{turn[0][k], turn[1][k], turn[2][k]}; };
    code.out.code += fmt::format("real3 cell_back_{}(real3 p, real3 g) {{\n", i);
    code.out.code += w.statements(roots, "    ");
    code.out.code +=
        fmt::format("    return real3({}, {}, {});\n}}\n", product(code, w, column(0), "g"),
                    product(code, w, column(1), "g"), product(code, w, column(2), "g"));
    code.finish(w);
}

void write_index(FieldCode& code, std::size_t i, const field::Cells& cells) {
    ExpressionWriter w = code.writer();
    code.out.code += fmt::format("real3 cell_index_{}(real3 p) {{\n", i);
    code.out.code += w.statements(cells.index, "    ");
    std::array<std::string, 3> numbers{"0.0", "0.0", "0.0"};
    for (std::size_t k = 0; k < cells.index.size(); ++k) numbers[k] = w.spelling(cells.index[k]);
    code.out.code +=
        fmt::format("    return real3({}, {}, {});\n}}\n", numbers[0], numbers[1], numbers[2]);
    code.finish(w);
}

}  // namespace

void write_cells(FieldCode& code) {
    for (std::size_t i = 0; i < code.plan.cells.size(); ++i) {
        const auto& cells = std::get<field::Cells>(code.field[code.plan.cells[i]]);
        write_way_in(code, i, cells);
        write_way_back(code, i);
        write_index(code, i, cells);
        code.needs("leaf/cells.glsl");
    }
}

}  // namespace shader
