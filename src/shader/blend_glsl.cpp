// SPDX-License-Identifier: MIT
// The functions of blends: the values of a tree, not answers along a ray, with what they change by.
#include <fmt/format.h>

#include "shader/field_code.h"

namespace shader {
namespace {

using field::FieldId;

/// What is written along with the values.
enum class Slope {
    size,  ///< about how fast a value changes: for leaves that are distances 1, without gradients
    gradient,  ///< in which direction, too: only of formulas
};

/// The names of a node's value, of its slope, and of the object that is nearest.
struct Names {
    std::string value, slope, object;
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

    Names names() const {
        return {fmt::format("v{}", number), fmt::format("s{}", number), fmt::format("o{}", number)};
    }
};

class BlendWriter {
public:
    BlendWriter(FieldCode& code, Slope slope, std::size_t first_object)
        : code_(code), slope_(slope), object_(first_object) {}

    Names write(FieldId id, const Place& place) {
        const field::Node node = code_.field[id];
        const Spot spot{id, place, count_++};
        return std::visit([&](const auto& it) { return write_node(it, spot); }, node);
    }
    const std::string& text() const { return text_; }

private:
    std::string_view slope_type() const { return slope_ == Slope::size ? "real" : "real3"; }
    void declare(const Names& names) {
        text_ += fmt::format("    real {};\n    {} {};\n    int {};\n", names.value, slope_type(),
                             names.slope, names.object);
    }
    void assign(const Names& names, const Names& from) {
        text_ += fmt::format("    {} = {};\n    {} = {};\n    {} = {};\n", names.value, from.value,
                             names.slope, from.slope, names.object, from.object);
    }
    Names leaf(const Spot& spot, const std::string& value, const std::string& slope) {
        const Names names = spot.names();
        declare(names);
        assign(names, {value, slope, std::to_string(object_++)});
        return names;
    }

    Names write_node(const field::Formula& node, const Spot& spot) {
        if (node.metric == field::Metric::distance && slope_ == Slope::size) {
            return leaf(spot, fmt::format("operand_value(distance_{}({}))", object_, spot.place.p),
                        "1.0");
        }
        const std::string g = fmt::format("g{}", spot.number);
        text_ += fmt::format("    real3 {};\n", g);
        return leaf(spot, fmt::format("operand_value(value_{}({}, {}))", object_, spot.place.p, g),
                    slope_ == Slope::size ? fmt::format("length({})", g) : g);
    }
    // An estimate behind a map that is no isometry is taken for the distance itself.
    Names write_node(const field::Iteration& node, const Spot& spot) {
        text_ += fmt::format("    bool in{0};\n    real f{0} = value_{1}({2}, in{0});\n",
                             spot.number, object_, spot.place.p);
        return leaf(spot,
                    node.escape ? fmt::format("escape_operand(f{0}, in{0})", spot.number)
                                : fmt::format("operand_value(f{})", spot.number),
                    "1.0");
    }
    template <class Pair>
    Names nearer(const Pair& node, const Spot& spot, char sign) {
        const Names a = write(node.a, spot.place), b = write(node.b, spot.place);
        const Names names = spot.names();
        declare(names);
        text_ += fmt::format("    if ({} {} {}) {{\n", b.value, sign, a.value);
        assign(names, b);
        text_ += "    } else {\n";
        assign(names, a);
        text_ += "    }\n";
        return names;
    }
    Names write_node(const field::Union& node, const Spot& spot) { return nearer(node, spot, '<'); }
    Names write_node(const field::Intersection& node, const Spot& spot) {
        return nearer(node, spot, '>');
    }
    Names write_node(const field::Complement& node, const Spot& spot) {
        const Names a = write(node.a, spot.place);
        return {fmt::format("(-{})", a.value),
                slope_ == Slope::size ? a.slope : fmt::format("(-{})", a.slope), a.object};
    }
    Names write_node(const field::Choice& node, const Spot& spot) {
        const Names names = spot.names();
        ExpressionWriter w = code_.writer(spot.place.p);
        declare(names);
        text_ += fmt::format("    if ({} < {}) {{\n", w.spelling(node.less), w.spelling(node.than));
        assign(names, write(node.a, spot.place));
        text_ += "    } else {\n";
        assign(names, write(node.b, spot.place));
        text_ += "    }\n";
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
        declare(names);
        text_ += "    {\n";
        write_mix(spot.id, node, operands, names, w);
        text_ += fmt::format("    }}\n    {} = {};\n", names.object, operands[0].object);
        if (operands.size() > 1) {
            text_ += fmt::format("    if (abs({}) < abs({})) {} = {};\n", operands[1].value,
                                 operands[0].value, names.object, operands[1].object);
        }
        code_.finish(w);
        return names;
    }
    /// Value and slope of a blend: the slopes of its operands by their weights.
    void write_mix(FieldId id, const field::Blend& node, const std::vector<Names>& operands,
                   const Names& names, ExpressionWriter& w) {
        const std::vector<graph::NodeId>& weights = code_.weights.at(id);
        std::vector<graph::NodeId> roots = weights;
        roots.push_back(node.value);
        if (node.displacement) {
            const Gradient& gradient = code_.displacements.at(id);
            roots.push_back(*node.displacement);
            roots.insert(roots.end(), gradient.begin(), gradient.end());
        }
        text_ += w.statements(roots, "        ");
        std::string value = w.spelling(node.value), slope;
        const bool size = slope_ == Slope::size;
        for (std::size_t i = 0; i < operands.size(); ++i) {
            slope += fmt::format(
                "{}{} * {}", slope.empty() ? "" : " + ",
                size ? fmt::format("abs({})", w.spelling(weights[i])) : w.spelling(weights[i]),
                operands[i].slope);
        }
        if (node.displacement) {
            const Gradient& g = code_.displacements.at(id);
            value += fmt::format(" + {}", w.spelling(*node.displacement));
            slope +=
                fmt::format(" + {}real3({}, {}, {}){}", size ? "length(" : "", w.spelling(g[0]),
                            w.spelling(g[1]), w.spelling(g[2]), size ? ")" : "");
        }
        text_ += fmt::format("        {} = {};\n        {} = {};\n", names.value, value,
                             names.slope, slope);
    }
    Names write_node(const field::Cells& node, const Spot& spot) {
        const Place inside{fmt::format("q{}", spot.number), fmt::format("e{}", spot.number)};
        const std::size_t cells = code_.plan.cells_number(spot.id);
        text_ += fmt::format(
            "    real3 {0}, {1};\n    real w{2};\n    cell_{3}({4}, {5}, {0}, {1}, w{2});\n"
            "    zs_limit = min(zs_limit, w{2});\n",
            inside.p, inside.d, spot.number, cells, spot.place.p, spot.place.d);
        Names names = write(node.a, inside);
        if (slope_ == Slope::gradient) {
            names.slope = fmt::format("cell_back_{}({}, {})", cells, spot.place.p, names.slope);
        }
        return names;
    }

    FieldCode& code_;
    Slope slope_;
    std::size_t object_;
    std::string text_;
    int count_ = 0;
};

}  // namespace

void write_blends(FieldCode& code) {
    for (std::size_t i = 0; i < code.plan.blends.size(); ++i) {
        const OuterBlend& blend = code.plan.blends[i];
        BlendWriter sizes(code, Slope::size, blend.first_object);
        const Names names = sizes.write(blend.id, {"p", "d"});
        code.out.code += fmt::format(
            "real blend_{}(real3 p, real3 d, out real slope, out int object) {{\n"
            "    zs_limit = zs_far;\n"
            "{}    slope = {};\n    object = {};\n    return {};\n}}\n",
            i, sizes.text(), names.slope, names.object, names.value);
        code.needs("leaf/blend.glsl");
        if (blend.iterates) continue;
        BlendWriter gradients(code, Slope::gradient, blend.first_object);
        const std::string gradient = gradients.write(blend.id, {"p", "d"}).slope;
        code.out.code += fmt::format(
            "real3 blend_gradient_{}(real3 p) {{\n    real3 d = real3(0.0);\n{}"
            "    return {};\n}}\n",
            i, gradients.text(), gradient);
    }
}

}  // namespace shader
