// SPDX-License-Identifier: MIT
// The functions of blends: the values of a tree, not answers along a ray.
#include <fmt/format.h>

#include "shader/field_code.h"

namespace shader {
namespace {

using field::FieldId;

/// The names of a node's value and of the object that is nearest.
struct Names {
    std::string value, object;
};

/// Where in space nodes are evaluated: the names of a point and of the ray's direction.
struct Place {
    std::string p, d;
};

/// A node that is being written.
struct Spot {
    FieldId id{};
    Place place;
    int number = 0;

    Names names() const { return {fmt::format("v{}", number), fmt::format("o{}", number)}; }
};

class BlendWriter {
public:
    BlendWriter(FieldCode& code, std::size_t first_object) : code_(code), object_(first_object) {}

    Names write(FieldId id, const Place& place) {
        const field::Node node = code_.field[id];
        const Spot spot{id, place, count_++};
        return std::visit([&](const auto& it) { return write_node(it, spot); }, node);
    }
    const std::string& text() const { return text_; }

private:
    Names leaf(const Spot& spot, const std::string& statements, const std::string& value) {
        const Names names = spot.names();
        text_ += statements;
        text_ += fmt::format("    real {} = {};\n    int {} = {};\n", names.value, value,
                             names.object, object_++);
        return names;
    }

    Names write_node(const field::Formula& node, const Spot& spot) {
        if (node.metric == field::Metric::distance) {
            return leaf(spot, "",
                        fmt::format("operand_value(distance_{}({}))", object_, spot.place.p));
        }
        return leaf(
            spot, fmt::format("    real3 g{};\n", spot.number),
            fmt::format("operand_value(value_{}({}, g{}))", object_, spot.place.p, spot.number));
    }
    Names write_node(const field::Iteration& node, const Spot& spot) {
        return leaf(spot,
                    fmt::format("    bool in{0};\n    real f{0} = value_{1}({2}, in{0});\n",
                                spot.number, object_, spot.place.p),
                    node.escape ? fmt::format("escape_operand(f{0}, in{0})", spot.number)
                                : fmt::format("operand_value(f{})", spot.number));
    }
    template <class Pair>
    Names nearer(const Pair& node, const Spot& spot, const char* function, char sign) {
        const Names a = write(node.a, spot.place), b = write(node.b, spot.place);
        const Names names = spot.names();
        text_ +=
            fmt::format("    real {} = {}({}, {});\n", names.value, function, a.value, b.value);
        text_ += fmt::format("    int {} = {} {} {} ? {} : {};\n", names.object, b.value, sign,
                             a.value, b.object, a.object);
        return names;
    }
    Names write_node(const field::Union& node, const Spot& spot) {
        return nearer(node, spot, "min", '<');
    }
    Names write_node(const field::Intersection& node, const Spot& spot) {
        return nearer(node, spot, "max", '>');
    }
    Names write_node(const field::Complement& node, const Spot& spot) {
        const Names a = write(node.a, spot.place);
        return {fmt::format("(-{})", a.value), a.object};
    }
    Names write_node(const field::Choice& node, const Spot& spot) {
        const Names names = spot.names();
        ExpressionWriter w = code_.writer(spot.place.p);
        text_ += fmt::format("    real {};\n    int {};\n    if ({} < {}) {{\n", names.value,
                             names.object, w.spelling(node.less), w.spelling(node.than));
        const Names a = write(node.a, spot.place);
        text_ += fmt::format("    {} = {};\n    {} = {};\n    }} else {{\n", names.value, a.value,
                             names.object, a.object);
        const Names b = write(node.b, spot.place);
        text_ += fmt::format("    {} = {};\n    {} = {};\n    }}\n", names.value, b.value,
                             names.object, b.object);
        return names;
    }
    Names write_node(const field::Blend& node, const Spot& spot) {
        std::vector<Names> operands;
        for (const FieldId id : node.operands) operands.push_back(write(id, spot.place));
        const Names names = spot.names();
        ExpressionWriter w = code_.writer(spot.place.p);
        for (std::size_t i = 0; i < operands.size(); ++i) {
            w.name(node.values[i], operands[i].value);
        }
        std::vector<graph::NodeId> roots{node.value};
        if (node.displacement) roots.push_back(*node.displacement);
        text_ += fmt::format("    real {};\n    {{\n", names.value);
        text_ += w.statements(roots, "        ");
        text_ += fmt::format("        {} = {}", names.value, w.spelling(node.value));
        if (node.displacement) text_ += fmt::format(" + {}", w.spelling(*node.displacement));
        text_ += ";\n    }\n";
        code_.finish(w);
        write_nearest(operands, names.object);
        return names;
    }
    void write_nearest(const std::vector<Names>& operands, const std::string& name) {
        text_ += fmt::format("    int {} = {};\n", name, operands[0].object);
        if (operands.size() < 2) return;
        text_ += fmt::format("    if (abs({}) < abs({})) {} = {};\n", operands[1].value,
                             operands[0].value, name, operands[1].object);
    }
    Names write_node(const field::Cells& node, const Spot& spot) {
        const Place inside{fmt::format("q{}", spot.number), fmt::format("e{}", spot.number)};
        text_ += fmt::format(
            "    real3 {0}, {1};\n    real w{2};\n    cell_{3}({4}, {5}, {0}, {1}, w{2});\n"
            "    zs_limit = min(zs_limit, w{2});\n",
            inside.p, inside.d, spot.number, code_.plan.cells_number(spot.id), spot.place.p,
            spot.place.d);
        return write(node.a, inside);
    }

    FieldCode& code_;
    std::size_t object_;
    std::string text_;
    int count_ = 0;
};

}  // namespace

void write_blends(FieldCode& code) {
    for (std::size_t i = 0; i < code.plan.blends.size(); ++i) {
        const OuterBlend& blend = code.plan.blends[i];
        BlendWriter writer(code, blend.first_object);
        const Names names = writer.write(blend.id, {"p", "d"});
        code.out.code += fmt::format(
            "real blend_{}(real3 p, real3 d, out int object) {{\n"
            "    zs_limit = zs_far;\n"
            "{}    object = {};\n"
            "    return {};\n"
            "}}\n",
            i, writer.text(), names.object, names.value);
        code.needs("leaf/blend.glsl");
    }
}

}  // namespace shader
