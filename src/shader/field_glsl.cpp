// SPDX-License-Identifier: MIT
#include "shader/field_glsl.h"

#include <algorithm>
#include <array>
#include <map>
#include <variant>

#include <fmt/format.h>

#include "passes/differentiate.h"
#include "passes/pipeline.h"
#include "shader/domain.h"
#include "shader/expression_glsl.h"
#include "shader/iteration_glsl.h"

namespace shader {
namespace {

using field::FieldId;
using graph::NodeId;

/// A leaf with its number as an object.
struct Leaf {
    FieldId id{};
    std::array<NodeId, 3> gradient{};  ///< of a formula
};

class FieldWriter {
public:
    FieldWriter(field::Field field, bool count_evaluations)
        : field_(std::move(field)), count_evaluations_(count_evaluations) {
        std::vector<NodeId> values;
        for (FieldId id : leaves(field_, field_.root)) {
            leaves_.push_back({id});
            const auto* leaf = std::get_if<field::Formula>(&field_[id]);
            if (leaf) values.push_back(leaf->value);
        }
        const auto gradients = passes::gradients(field_.graph, values);
        auto next = gradients.begin();
        for (Leaf& leaf : leaves_) {
            if (std::holds_alternative<field::Formula>(field_[leaf.id])) leaf.gradient = *next++;
        }
        write_domain();
        make_cheap();
        depends_ = depends_on_variables(field_.graph);
    }

    FieldGlsl write() {
        for (std::size_t i = 0; i < leaves_.size(); ++i) write_leaf(i);
        write_sides();
        write_tree();
        write_gradients();
        write_colours();
        out_.values = values_.list();
        out_.expressions = eval::make_tape(field_.graph, values_.expressions());
        return std::move(out_);
    }

private:
    /// The last passes see values and gradients together, which share much.
    void make_cheap() {
        std::vector<NodeId*> places = passes::all_expressions(field_);
        for (Leaf& leaf : leaves_) {
            if (!std::holds_alternative<field::Formula>(field_[leaf.id])) continue;
            for (NodeId& slope : leaf.gradient) places.push_back(&slope);
        }
        std::vector<NodeId> roots;
        for (const NodeId* place : places) roots.push_back(*place);
        const std::vector<NodeId> cheap =
            passes::run(field_.graph, roots, passes::Stage::evaluation);
        for (std::size_t i = 0; i < places.size(); ++i) *places[i] = cheap[i];
    }

    const field::Formula* formula(std::size_t i) const {
        return std::get_if<field::Formula>(&field_[leaves_[i].id]);
    }
    bool is_sheet(std::size_t i) const {
        return formula(i) && formula(i)->kind == field::Kind::sheet;
    }

    ExpressionWriter writer() {
        return {
            field_.graph,
            depends_,
            values_,
            {{graph::variable_x, "p.x"}, {graph::variable_y, "p.y"}, {graph::variable_z, "p.z"}}};
    }

    void write_domain() {
        std::vector<NodeId> values;
        for (std::size_t i = 0; i < leaves_.size(); ++i) {
            if (formula(i)) values.push_back(formula(i)->value);
        }
        const bool edges = may_be_undefined(field_.graph, values);
        out_.code += fmt::format("const bool zs_has_edges = {};\n", edges);
    }

    void write_leaf(std::size_t i) {
        if (const auto* iteration = std::get_if<field::Iteration>(&field_[leaves_[i].id])) {
            write_iteration(i, *iteration);
        } else if (formula(i)->metric == field::Metric::distance && !is_sheet(i)) {
            write_distance(i, *formula(i));
        } else {
            write_scalar(i, *formula(i));
        }
    }

    void write_iteration(std::size_t i, const field::Iteration& iteration) {
        ExpressionWriter w = writer();
        out_.code += fmt::format("real value_{}(real3 p, out bool inside) {{\n", i);
        out_.code += iteration_body(field_.graph, iteration, w, values_);
        out_.code += "}\n";
        out_.code += fmt::format(
            "Answer leaf_{0}(real3 p, real3 d) {{\n"
            "    bool inside;\n"
            "    real f = value_{0}(p, inside);\n"
            "    return iteration_answer(f, inside, {1}, {0});\n"
            "}}\n",
            i, iteration.escape ? "4.0" : "1.0");
        finish(w, "leaf/iteration.glsl");
        out_.has_iterations = true;
    }

    /// Value and gradient in one function.
    void write_value_and_gradient(std::size_t i, ExpressionWriter& w) {
        const auto& g = leaves_[i].gradient;
        const std::array roots{formula(i)->value, g[0], g[1], g[2]};
        out_.code += fmt::format("real value_{}(real3 p, out real3 g) {{\n", i);
        out_.code += w.statements(roots, "    ");
        out_.code +=
            fmt::format("    g = real3({}, {}, {});\n    return {};\n}}\n", w.spelling(roots[1]),
                        w.spelling(roots[2]), w.spelling(roots[3]), w.spelling(roots[0]));
    }

    void write_distance(std::size_t i, const field::Formula& leaf) {
        ExpressionWriter alone = writer();
        out_.code += fmt::format("real distance_{}(real3 p) {{\n", i);
        out_.code += alone.statements(std::array{leaf.value}, "    ");
        out_.code += fmt::format("    return {};\n}}\n", alone.spelling(leaf.value));
        ExpressionWriter both = writer();
        write_value_and_gradient(i, both);
        out_.code += fmt::format(
            "Answer leaf_{0}(real3 p, real3 d) {{ return distance_answer(distance_{0}(p), {0}); "
            "}}\n",
            i);
        finish(alone, "leaf/distance.glsl");
        finish(both, "leaf/distance.glsl");
    }

    void write_scalar(std::size_t i, const field::Formula&) {
        ExpressionWriter w = writer();
        write_value_and_gradient(i, w);
        const FieldId id = leaves_[i].id;
        // One after the other: the order of arguments is the compiler's choice.
        const std::string lipschitz = values_.bound(FieldValue::What::inverse_lipschitz, id);
        const std::string second = values_.bound(FieldValue::What::second_derivative, id);
        const std::string first = values_.bound(FieldValue::What::first_order, id);
        const std::string bounds = fmt::format("real3({}, {}, {})", lipschitz, second, first);
        const std::string answer =
            is_sheet(i)
                ? fmt::format("sheet_answer(f, g, d, {}, side_{}, now_{}, {})", bounds, i, i, i)
                : fmt::format("formula_answer(f, g, d, {}, {})", bounds, i);
        if (is_sheet(i)) out_.code += fmt::format("real side_{0} = 0.0, now_{0} = 0.0;\n", i);
        out_.code += fmt::format(
            "Answer leaf_{0}(real3 p, real3 d) {{\n"
            "    real3 g;\n"
            "    real f = value_{0}(p, g);\n"
            "    return {1};\n"
            "}}\n",
            i, answer);
        finish(w, is_sheet(i) ? "leaf/sheet.glsl" : "leaf/formula.glsl");
    }

    void finish(const ExpressionWriter& w, const char* leaf_part) {
        add_operators(w);
        out_.leaf_parts.insert(leaf_part);
    }
    void add_operators(const ExpressionWriter& w) {
        out_.operator_parts.insert(w.operator_parts().begin(), w.operator_parts().end());
    }

    void write_sides() {
        std::string start, accept;
        for (std::size_t i = 0; i < leaves_.size(); ++i) {
            if (!is_sheet(i)) continue;
            start += fmt::format("    side_{} = 0.0;\n", i);
            accept += fmt::format("    side_{0} = now_{0};\n", i);
        }
        out_.code += fmt::format("void field_start() {{\n{}}}\n", start);
        out_.code += fmt::format("void field_accept() {{\n{}}}\n", accept);
    }

    void write_tree() {
        std::string body;
        int leaf = 0, count = 0;
        const std::string root = write_node(field_.root, body, leaf, count);
        out_.code += fmt::format(
            "{}Answer field(real3 p, real3 d) {{\n"
            "    zs_undefined = 0;\n"
            "    zs_guess = false;\n"
            "    zs_point = p;\n"
            "{}{}    return {};\n"
            "}}\n",
            count_evaluations_ ? "int zs_evaluations = 0;\n" : "",
            count_evaluations_ ? "    ++zs_evaluations;\n" : "", body, root);
    }

    /// Writes the statements of a node and returns the name of its answer.
    std::string write_node(FieldId id, std::string& body, int& leaf, int& count) {
        std::string right;
        const auto child = [&](FieldId c) { return write_node(c, body, leaf, count); };
        if (const auto* u = std::get_if<field::Union>(&field_[id])) {
            const std::string a = child(u->a), b = child(u->b);
            right = fmt::format("answer_union({}, {})", a, b);
        } else if (const auto* n = std::get_if<field::Intersection>(&field_[id])) {
            const std::string a = child(n->a), b = child(n->b);
            right = kind_of(field_, n->a) == field::Kind::sheet
                        ? fmt::format("answer_clip({}, {})", a, b)
                    : kind_of(field_, n->b) == field::Kind::sheet
                        ? fmt::format("answer_clip({}, {})", b, a)
                        : fmt::format("answer_intersection({}, {})", a, b);
        } else if (const auto* c = std::get_if<field::Complement>(&field_[id])) {
            right = fmt::format("answer_complement({})", child(c->a));
        } else if (const auto* s = std::get_if<field::SmoothUnion>(&field_[id])) {
            const std::string a = child(s->a), b = child(s->b);
            right = fmt::format("answer_smooth_union({}, {}, {})", a, b, writer().spelling(s->k));
            out_.leaf_parts.insert("leaf/smooth_union.glsl");
        } else {
            right = fmt::format("leaf_{}(p, d)", leaf++);
        }
        const std::string name = fmt::format("a{}", count++);
        body += fmt::format("    Answer {} = {};\n", name, right);
        return name;
    }

    void write_gradients() {
        std::string distances, gradients;
        for (std::size_t i = 0; i < leaves_.size(); ++i) {
            if (formula(i)) {
                gradients += fmt::format("    if (object == {0}) value_{0}(p, g);\n", i);
            } else {
                distances +=
                    fmt::format("    if (object == {0}) return value_{0}(p, inside);\n", i);
            }
        }
        if (out_.has_iterations) {
            out_.code += fmt::format(
                "real object_distance(int object, real3 p) {{\n"
                "    bool inside;\n"
                "{}    return 0.0;\n"
                "}}\n",
                distances);
            out_.code += "real3 object_differences(int object, real3 p, real h);\n";
        }
        out_.code += fmt::format(
            "real3 object_gradient(int object, real3 p, real h) {{\n"
            "    real3 g = real3(0.0);\n"
            "{}{}    return g;\n"
            "}}\n",
            gradients, differences_call());
    }

    std::string differences_call() const {
        std::string condition;
        for (std::size_t i = 0; i < leaves_.size(); ++i) {
            if (formula(i)) continue;
            condition += fmt::format("{}object == {}", condition.empty() ? "" : " || ", i);
        }
        if (condition.empty()) return "";
        return fmt::format("    if ({}) g = object_differences(object, p, h);\n", condition);
    }

    void write_colours() {
        std::string calls;
        for (std::size_t i = 0; i < leaves_.size(); ++i) {
            const std::optional<field::Colour> colour = colour_of(field_[leaves_[i].id]);
            if (!colour) continue;
            ExpressionWriter w = writer();
            const auto* iteration = std::get_if<field::Iteration>(&field_[leaves_[i].id]);
            const std::string body = iteration
                                         ? iteration_colour(field_.graph, *iteration, w, values_)
                                         : w.statements(*colour, "    ");
            out_.code += fmt::format("real3 colour_{}(real3 p) {{\n{}", i, body);
            out_.code +=
                fmt::format("    return real3({}, {}, {});\n}}\n", w.spelling((*colour)[0]),
                            w.spelling((*colour)[1]), w.spelling((*colour)[2]));
            add_operators(w);
            calls += fmt::format(
                "    if (object == {0}) {{\n        colour = colour_{0}(p);\n        return "
                "true;\n    "
                "}}\n",
                i);
        }
        out_.has_colours = !calls.empty();
        if (!out_.has_colours) return;
        out_.code += fmt::format(
            "bool object_colour(int object, real3 p, out real3 colour) {{\n{}"
            "    return false;\n}}\n",
            calls);
    }

    field::Field field_;
    bool count_evaluations_;
    std::vector<Leaf> leaves_;
    std::vector<bool> depends_;
    FieldValues values_;
    FieldGlsl out_;
};

}  // namespace

FieldGlsl field_glsl(field::Field field, bool count_evaluations) {
    return FieldWriter(std::move(field), count_evaluations).write();
}

}  // namespace shader
