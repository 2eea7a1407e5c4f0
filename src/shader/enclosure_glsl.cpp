// SPDX-License-Identifier: MIT
// The tree over an interval of a ray.
#include <fmt/format.h>

#include "shader/field_code.h"
#include "shader/interval_writer.h"

namespace shader {
namespace {

using field::FieldId;

/// The function over_i(o, d, t) of a formula.
void write_formula(FieldCode& code, std::size_t i, const field::Formula& leaf) {
    IntervalWriter w(
        code.field.graph, code.depends, code.values,
        {{graph::variable_x, "x"}, {graph::variable_y, "y"}, {graph::variable_z, "z"}});
    std::string text = fmt::format("Enclosure over_{}(real3 o, real3 d, real2 t) {{\n", i);
    for (const char axis : {'x', 'y', 'z'}) {
        text += fmt::format("    real2 {0} = interval_along(o.{0}, d.{0}, t);\n", axis);
    }
    // Derivatives may jump where the value does not: only what the value does counts.
    text += "    zs_breaks = false;\n";
    text += w.statements(leaf.value, "    ");
    text += "    bool breaks = zs_breaks;\n";
    const Gradient& g = code.gradients.at(code.plan.objects[i].id);
    for (const graph::NodeId slope : g) text += w.statements(slope, "    ");
    text += fmt::format("    real2 rate = enclosed_rate({}, {}, {}, d, breaks);\n",
                        w.spelling(g[0]), w.spelling(g[1]), w.spelling(g[2]));
    text += leaf.kind == field::Kind::sheet
                ? fmt::format("    return sheet_enclosure({}, rate);\n", w.spelling(leaf.value))
                : fmt::format("    return solid_enclosure({}, rate, breaks);\n",
                              w.spelling(leaf.value));
    code.out.code += text + "}\n";
    code.out.interval_parts.insert(w.parts().begin(), w.parts().end());
}

class EnclosureWriter {
public:
    explicit EnclosureWriter(FieldCode& code) : code_(code) {}

    /// Writes the statements of a node and returns the name of its enclosure.
    std::string write(FieldId id) {
        const field::Node node = code_.field[id];
        std::string name;
        const std::string right =
            std::visit([&](const auto& it) { return enclosure(id, it, name); }, node);
        if (name.empty()) {
            name = fresh();
            body_ += fmt::format("    Enclosure {} = {};\n", name, right);
        }
        return name;
    }
    const std::string& body() const { return body_; }
    /// Whether a node is asked at a point.
    bool asks_points() const { return asks_points_; }

private:
    std::string fresh() { return fmt::format("e{}", count_++); }
    std::string at_point(const std::string& answer) {
        asks_points_ = true;
        return fmt::format("answer_enclosure({}(p, d), t)", answer);
    }
    bool is_sheet(FieldId id) const { return kind_of(code_.field, id) == field::Kind::sheet; }

    std::string enclosure(FieldId, const field::Formula& leaf, std::string&) {
        write_formula(code_, object_, leaf);
        return fmt::format("over_{}(o, d, t)", object_++);
    }
    std::string enclosure(FieldId, const field::Iteration&, std::string&) {
        return at_point(fmt::format("leaf_{}", object_++));
    }
    template <class Pair>
    std::string pair(const char* operation, const Pair& node) {
        const std::string a = write(node.a), b = write(node.b);
        return fmt::format("enclosure_{}({}, {}, {})", operation, a, b,
                           is_sheet(node.a) || is_sheet(node.b));
    }
    std::string enclosure(FieldId, const field::Union& node, std::string&) {
        return pair("union", node);
    }
    std::string enclosure(FieldId, const field::Intersection& node, std::string&) {
        return pair("intersection", node);
    }
    std::string enclosure(FieldId, const field::Complement& node, std::string&) {
        return fmt::format("enclosure_complement({})", write(node.a));
    }
    std::string enclosure(FieldId, const field::Choice& node, std::string& name) {
        ExpressionWriter w = code_.writer();
        name = fresh();
        body_ += fmt::format("    Enclosure {};\n    if ({} < {}) {{\n", name,
                             w.spelling(node.less), w.spelling(node.than));
        const std::string a = write(node.a);
        body_ += fmt::format("    {} = {};\n    }} else {{\n", name, a);
        const std::string b = write(node.b);
        body_ += fmt::format("    {} = {};\n    }}\n", name, b);
        return {};
    }
    std::string part(FieldId id) {
        object_ += leaves(code_.field, id).size();
        return at_point(fmt::format("part_{}", parts_++));
    }
    std::string enclosure(FieldId id, const field::Blend&, std::string&) { return part(id); }
    std::string enclosure(FieldId id, const field::Cells&, std::string&) { return part(id); }

    FieldCode& code_;
    std::string body_;
    std::size_t object_ = 0;
    int count_ = 0, parts_ = 0;
    bool asks_points_ = false;
};

}  // namespace

void write_enclosures(FieldCode& code, bool count_evaluations) {
    EnclosureWriter tree(code);
    const std::string root = tree.write(code.field.root);
    code.out.code += fmt::format(
        "Enclosure enclose(real3 o, real3 d, real2 t) {{\n"
        "{}{}{}    return {};\n"
        "}}\n",
        count_evaluations ? "    ++zs_evaluations;\n" : "",
        tree.asks_points() ? "    real3 p = o + t.x * d;\n    zs_point = p;\n    field_forget();\n"
                           : "",
        tree.body(), root);
}

}  // namespace shader
