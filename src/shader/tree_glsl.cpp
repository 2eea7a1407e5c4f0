// SPDX-License-Identifier: MIT
// The answer of the whole tree along a ray.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "shader/field_code.h"

namespace shader {
namespace {

using field::FieldId;

/// Where in space nodes are asked: the names of a point and of the ray's direction.
struct Place {
    std::string p = "p", d = "d";
    std::vector<int> cells{};  ///< the numbers of the cells around it
};

class TreeWriter {
public:
    explicit TreeWriter(FieldCode& code) : code_(code) {}

    /// Writes the statements of a node and returns the name of its answer.
    std::string write(FieldId id, const Place& place) {
        const field::Node node = code_.field[id];
        const bool apart = std::holds_alternative<field::Blend>(node) ||
                           std::holds_alternative<field::Cells>(node);
        if (code_.demands.intervals && apart && !in_part_) return write_part(id, place);
        std::string name;
        const std::string right =
            std::visit([&](const auto& it) { return answer(id, it, place, name); }, node);
        if (name.empty()) {
            name = fresh();
            body_ += fmt::format("    Answer {} = {};\n", name, right);
        }
        return name;
    }

    const std::string& body() const { return body_; }
    const std::string& parts() const { return parts_; }
    /// The cells in which there are sheets, by number.
    const std::vector<int>& watched_cells() const { return watched_; }

private:
    std::string fresh() { return fmt::format("a{}", count_++); }

    /// The answer of a node by a function of its own.
    std::string write_part(FieldId id, const Place& place) {
        const std::string outside = std::exchange(body_, {});
        in_part_ = true;
        const std::string answer = write(id, {});
        in_part_ = false;
        parts_ += fmt::format("Answer part_{}(real3 p, real3 d) {{\n{}    return {};\n}}\n",
                              part_count_, body_, answer);
        body_ = outside;
        const std::string name = fresh();
        body_ += fmt::format("    Answer {} = part_{}({}, {});\n", name, part_count_++, place.p,
                             place.d);
        return name;
    }

    std::string leaf(const Place& place) {
        const std::size_t i = object_++;
        if (code_.is_sheet(i)) {
            // What is known of the side belongs to the cell where the ray was before.
            for (const int cell : place.cells) {
                body_ += fmt::format("    if (here_{0} != before_{0}) side_{1} = 0.0;\n", cell, i);
                if (std::ranges::count(watched_, cell) == 0) watched_.push_back(cell);
            }
        }
        if (code_.along.contains(i)) return fmt::format("leaf_{}(s, {}, {})", i, place.p, place.d);
        return fmt::format("leaf_{}({}, {})", i, place.p, place.d);
    }
    std::string answer(FieldId, const field::Formula&, const Place& place, std::string&) {
        return leaf(place);
    }
    std::string answer(FieldId, const field::Iteration&, const Place& place, std::string&) {
        return leaf(place);
    }
    std::string answer(FieldId id, const field::Union& node, const Place& place, std::string&) {
        if (code_.gathered.contains(id)) {
            object_ += leaves(code_.field, id).size();
            return fmt::format("family_{}({})", family_++, place.p);
        }
        const std::string a = write(node.a, place), b = write(node.b, place);
        return fmt::format("answer_union({}, {})", a, b);
    }
    std::string answer(FieldId, const field::Intersection& node, const Place& place, std::string&) {
        const std::string a = write(node.a, place), b = write(node.b, place);
        const bool a_is_sheet = kind_of(code_.field, node.a) == field::Kind::sheet;
        const bool b_is_sheet = kind_of(code_.field, node.b) == field::Kind::sheet;
        code_.clips = code_.clips || a_is_sheet || b_is_sheet;
        if (a_is_sheet) return fmt::format("answer_clip({}, {})", a, b);
        if (b_is_sheet) return fmt::format("answer_clip({}, {})", b, a);
        return fmt::format("answer_intersection({}, {})", a, b);
    }
    std::string answer(FieldId, const field::Complement& node, const Place& place, std::string&) {
        return fmt::format("answer_complement({})", write(node.a, place));
    }
    std::string answer(FieldId, const field::Choice& node, const Place& place, std::string& name) {
        ExpressionWriter w = code_.writer(place.p);
        name = fresh();
        body_ += fmt::format("    Answer {};\n    if ({} < {}) {{\n", name, w.spelling(node.less),
                             w.spelling(node.than));
        const std::string a = write(node.a, place);
        body_ += fmt::format("    {} = {};\n    }} else {{\n", name, a);
        const std::string b = write(node.b, place);
        body_ += fmt::format("    {} = {};\n    }}\n", name, b);
        return {};
    }
    std::string answer(FieldId id, const field::Blend&, const Place& place, std::string&) {
        const std::size_t i = blend_++;
        const OuterBlend& blend = code_.plan.blends[i];
        object_ += leaves(code_.field, id).size();
        const std::string inverse =
            code_.values.bound({FieldValue::What::inverse_lipschitz, id, blend.cells});
        body_ += fmt::format(
            "    int k{0};\n    real s{0};\n    real f{0} = blend_{0}({1}, {2}, s{0}, k{0});\n", i,
            place.p, place.d);
        return fmt::format("blend_answer(f{0}, s{0}, {1}, {2}, k{0})", i, inverse,
                           blend.escapes ? "4.0" : "1.0");
    }
    std::string answer(FieldId id, const field::Cells& node, const Place& place, std::string&) {
        const int number = cells_++;
        const std::size_t function = code_.plan.cells_number(id);
        body_ += fmt::format(
            "    real3 q{0}, e{0};\n    real w{0};\n    cell_{1}({2}, {3}, q{0}, e{0}, w{0});\n",
            number, function, place.p, place.d);
        if (kind_of(code_.field, node.a) == field::Kind::sheet) {
            body_ += fmt::format("    here_{} = cell_index_{}({});\n", number, function, place.p);
        }
        Place inside{fmt::format("q{}", number), fmt::format("e{}", number), place.cells};
        inside.cells.push_back(number);
        return fmt::format("answer_cell({}, w{})", write(node.a, inside), number);
    }

    FieldCode& code_;
    std::string body_, parts_;
    bool in_part_ = false;
    int part_count_ = 0;
    std::vector<int> watched_;
    std::size_t object_ = 0, blend_ = 0, family_ = 0;
    int count_ = 0, cells_ = 0;
};

/// What is the same all along a ray.
std::string ray_start(const FieldCode& code) {
    if (code.along.empty()) return {};
    std::string text =
        "    zs_middle = 0.5 * (t0 + t1);\n"
        "    zs_half = 0.5 * (t1 - t0);\n"
        "    zs_half_inverse = 1.0 / zs_half;\n"
        "    real3 c = o + zs_middle * d, e = zs_half * d;\n";
    for (const auto& [object, coefficients] : code.along) {
        text += fmt::format("    coefficients_{}(c, e);\n", object);
    }
    return text;
}

void write_sides(FieldCode& code, const std::vector<int>& watched_cells) {
    std::string start, accept;
    for (std::size_t i = 0; i < code.plan.objects.size(); ++i) {
        if (!code.is_sheet(i)) continue;
        start += fmt::format("    side_{} = 0.0;\n", i);
        accept += fmt::format("    side_{0} = now_{0};\n", i);
    }
    for (const int cell : watched_cells) {
        code.out.code += fmt::format("real3 here_{0} = real3(0.0), before_{0} = here_{0};\n", cell);
        accept += fmt::format("    before_{0} = here_{0};\n", cell);
    }
    code.out.code += fmt::format("void field_forget() {{\n{}}}\n", start);
    code.out.code += fmt::format(
        "void field_start(real3 o, real3 d, real t0, real t1) {{\n    field_forget();\n{}}}\n",
        ray_start(code));
    code.out.code += fmt::format("void field_accept() {{\n{}}}\n", accept);
}

}  // namespace

void write_tree(FieldCode& code, bool count_evaluations) {
    TreeWriter tree(code);
    const std::string root = tree.write(code.field.root, {});
    write_sides(code, tree.watched_cells());
    code.out.code += tree.parts();
    code.out.code += fmt::format(
        "{}Answer field(real3 o, real3 d, real t) {{\n"
        "    real3 p = o + t * d;\n"
        "    zs_undefined = 0;\n"
        "    zs_guess = false;\n"
        "    zs_evenness = 1.0;\n"
        "    zs_point = p;\n"
        "{}{}{}{}    return {};\n"
        "}}\n",
        count_evaluations ? "int zs_evaluations = 0;\n" : "",
        code.plan.cells.empty() && code.jump_walls.empty() ? "" : "    zs_wall = zs_far;\n",
        count_evaluations ? "    ++zs_evaluations;\n" : "",
        code.along.empty() ? "" : "    real s = (t - zs_middle) * zs_half_inverse;\n", tree.body(),
        root);
}

}  // namespace shader
