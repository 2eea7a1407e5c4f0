// SPDX-License-Identifier: MIT
// The functions of families: their members by rows of numbers, and the union of those that a list
// names.
#include <fmt/format.h>

#include "passes/differentiate.h"
#include "shader/field_code.h"

namespace shader {
namespace {

using graph::NodeId;

/// How a row's number is spelt, in texels m0, m1, ...
std::string component(std::size_t number) {
    return fmt::format("m{}.{}", number / 4, "xyzw"[number % 4]);
}

/// What is asked of a member.
enum class Asked { value, gradient, colour };

class MemberWriter {
public:
    MemberWriter(FieldCode& code, const CodedFamily& family) : code_(code), family_(family) {}

    /// The statements of a function of the point `p` and the row's place `at`.
    std::string body(Asked asked) {
        const std::vector<MemberKind>& kinds = family_.it.kinds;
        std::string text = texels(asked);
        if (kinds.size() == 1) return text + answer(0, asked, "    ");
        text += fmt::format("    int kind = int({});\n", component(family_.kind_place()));
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            text +=
                fmt::format("    if (kind == {}) {{\n{}    }}\n", i, answer(i, asked, "        "));
        }
        return text;
    }
    std::string_view result(Asked asked) const {
        switch (asked) {
            case Asked::value:
                return "real f = 0.0";
            case Asked::gradient:
                return "real3 g = real3(0.0)";
            case Asked::colour:
                return "real4 colour = real4(0.0)";
        }
        return {};
    }

private:
    std::string texels(Asked asked) const {
        std::size_t most = 0;
        for (const MemberKind& kind : family_.it.kinds) {
            most =
                std::max(most, asked == Asked::colour ? kind.variables.size() : kind.value_numbers);
        }
        std::string text;
        for (std::size_t i = 0; i < family_.texels; ++i) {
            const bool has_kind = family_.it.kinds.size() > 1 && family_.kind_place() / 4 == i;
            if (4 * i >= most && !has_kind) continue;
            text += fmt::format("    real4 m{0} = texelFetch(family_numbers, at + {0});\n", i);
        }
        return text;
    }

    std::string answer(std::size_t number, Asked asked, const std::string& indent) {
        const MemberKind& kind = family_.it.kinds[number];
        ExpressionWriter w = code_.writer();
        for (std::size_t i = 0; i < kind.variables.size(); ++i) {
            w.name(kind.variables[i], component(i));
        }
        const Gradient& g = family_.gradients[number];
        std::string text;
        if (asked == Asked::value) {
            text = w.statements(std::array{kind.value}, indent);
            text += fmt::format("{}f = {};\n", indent, w.spelling(kind.value));
        } else if (asked == Asked::gradient) {
            text = w.statements(g, indent);
            text += fmt::format("{}g = real3({}, {}, {});\n", indent, w.spelling(g[0]),
                                w.spelling(g[1]), w.spelling(g[2]));
        } else if (kind.colour) {
            const field::Colour& c = *kind.colour;
            text = w.statements(c, indent);
            text += fmt::format("{}colour = real4({}, {}, {}, 1.0);\n", indent, w.spelling(c[0]),
                                w.spelling(c[1]), w.spelling(c[2]));
        }
        code_.finish(w);
        return text;
    }

    FieldCode& code_;
    const CodedFamily& family_;
};

void write_members(FieldCode& code, const CodedFamily& family, std::size_t i) {
    MemberWriter writer(code, family);
    const auto write = [&](Asked asked, std::string_view type, std::string_view name,
                           std::string_view returned) {
        code.out.code +=
            fmt::format("{} {}_{}(real3 p, int at) {{\n    {};\n{}    return {};\n}}\n", type, name,
                        i, writer.result(asked), writer.body(asked), returned);
    };
    write(Asked::value, "real", "member", "f");
    write(Asked::gradient, "real3", "member_gradient", "g");
    if (family.has_colours()) write(Asked::colour, "real4", "member_colour", "colour");
}

/// How a tree's heads are asked for the cell that `p` is in.
std::string cell_at_point(FieldCode& code, const FamilyTree& tree) {
    std::array<std::string, family_head_size - 1> told;
    for (std::size_t k = 0; k < told.size(); ++k) {
        told[k] = code.values.bound(
            {.what = FieldValue::What::family, .family = tree.first, .component = k});
    }
    return fmt::format("family_cell(p, real3({}, {}, {}), {}, real3({}, {}, {}), {}, {})", told[0],
                       told[1], told[2], told[3], told[4], told[5], told[6], told[7],
                       tree.head_texels());
}

/// Where one of a tree's lists ends; -1 is where the first one begins.
std::string list_end(int family) {
    const std::size_t place =
        family < 0 ? 0 : FamilyTree::end_place(static_cast<std::size_t>(family));
    if (place < 4) return fmt::format("int(cell.first.{})", "xyzw"[place]);
    return fmt::format("int(texelFetch(family_numbers, cell.head + {}).{})", place / 4,
                       "xyzw"[place % 4]);
}

/// A far cell has no list: all members.
std::string list_in_cell(const FieldCode& code, std::size_t family) {
    const auto tree = std::ranges::find_if(
        code.trees, [&](const CodedTree& each) { return family - each.it.first < each.it.count; });
    const int place = static_cast<int>(family - tree->it.first);
    const CodedFamily& all = code.families[family];
    const std::string listed = fmt::format("ivec2({}, {})", list_end(place - 1), list_end(place));
    if (!tree->it.may_be_far) return listed;
    return fmt::format("cell.first.w == 0.0 ? {0} : ivec2(int({1}), int({1}) + {2})", listed,
                       all.rows, all.texels * all.it.members.size());
}

void write_union(FieldCode& code, const CodedFamily& family, std::size_t i) {
    code.out.code += fmt::format(
        "Answer family_{0}(real3 p) {{\n"
        "    FamilyCell cell = {1};\n"
        "{4}"
        "    ivec2 list = ivec2({5}, {6});\n"
        "    real least = zs_far;\n"
        "    int nearest = list.x;\n"
        "    for (int at = list.x; at < list.y; at += {2}) {{\n"
        "        real f = member_{0}(p, at);\n"
        "        if (f < least) {{\n"
        "            least = f;\n"
        "            nearest = at;\n"
        "        }}\n"
        "    }}\n"
        "    return distance_answer(least, int(texelFetch(family_numbers, nearest + {3}).w));\n"
        "}}\n",
        i, code.trees[i].cell, family.texels, family.texels - 1,
        far_statement(code.trees[i], family.first_object), list_end(-1), list_end(0));
    code.needs("leaf/distance.glsl");
}

/// `f` joined with another value, or its part in the gradient.
std::string joined(FieldCode& code, const CodedFamily& family, std::string_view what,
                   std::string_view value) {
    const std::string width =
        family.it.width ? fmt::format(", {}", code.writer().spelling(*family.it.width)) : "";
    return fmt::format("{}_{}(f, {}{})", family.it.width ? "smooth" : "plain", what, value, width);
}

/// The minimum of those in the list, two at a time: a turn of the loop costs as much as a member.
void write_minimum(FieldCode& code, const CodedFamily& family, std::size_t i) {
    code.out.code += fmt::format(
        "real minimum_{0}(real3 p, FamilyCell cell) {{\n"
        "    ivec2 list = {1};\n"
        "    real f = zs_far;\n"
        "    for (int at = list.x; at < list.y; at += {2}) {{\n"
        "        real a = member_{0}(p, at), b = member_{0}(p, at + {3});\n"
        "        f = {4};\n"
        "        if (at + {3} < list.y) f = {5};\n"
        "    }}\n"
        "    return f;\n"
        "}}\n",
        i, list_in_cell(code, i), 2 * family.texels, family.texels,
        joined(code, family, "minimum", "a"), joined(code, family, "minimum", "b"));
    code.needs("leaf/minimum.glsl");
}

/// The same with its gradient.
void write_minimum_gradient(FieldCode& code, const CodedFamily& family, std::size_t i) {
    code.out.code += fmt::format(
        "real minimum_{0}(real3 p, FamilyCell cell, out real3 g) {{\n"
        "    ivec2 list = {1};\n"
        "    real f = zs_far;\n"
        "    g = real3(0.0);\n"
        "    for (int at = list.x; at < list.y; at += {2}) {{\n"
        "        real a = member_{0}(p, at);\n"
        "        g = mix(g, member_gradient_{0}(p, at), {3});\n"
        "        f = {4};\n"
        "    }}\n"
        "    return f;\n"
        "}}\n",
        i, list_in_cell(code, i), family.texels, joined(code, family, "weight", "a"),
        joined(code, family, "minimum", "a"));
}

}  // namespace

std::string far_statement(const CodedTree& tree, std::size_t object) {
    if (!tree.it.may_be_far) return {};
    return fmt::format("    if (cell.first.w != 0.0) return family_far(cell, {});\n", object);
}

const CodedTree* tree_of(const FieldCode& code, std::size_t object) {
    const auto found = code.minima.find(object);
    if (found == code.minima.end()) return nullptr;
    std::size_t family = code.families.size();
    for (const auto& [variable, number] : found->second) family = std::min(family, number);
    return &*std::ranges::find_if(code.trees,
                                  [&](const CodedTree& tree) { return tree.it.first == family; });
}

std::string minima_statements(const FieldCode& code, std::size_t object, ExpressionWriter& writer,
                              bool gradients) {
    const CodedTree* tree = tree_of(code, object);
    if (!tree) return {};
    std::string text;
    for (const auto& [variable, family] : code.minima.at(object)) {
        text += gradients ? fmt::format(
                                "    real3 g_{0};\n    real f_{0} = minimum_{0}(p, cell, "
                                "g_{0});\n",
                                family)
                          : fmt::format("    real f_{0} = minimum_{0}(p, cell);\n", family);
        writer.name(variable, fmt::format("f_{}", family));
    }
    return text;
}

void write_families(FieldCode& code) {
    for (CodedTree& tree : code.trees) {
        tree.cell = cell_at_point(code, tree.it);
        code.out.family_trees.push_back(tree.it);
    }
    for (std::size_t i = 0; i < code.families.size(); ++i) {
        CodedFamily& family = code.families[i];
        family.rows = code.values.bound({.what = FieldValue::What::family,
                                         .family = i,
                                         .component = static_cast<std::size_t>(FamilyHead::rows)});
        write_members(code, family, i);
        if (i < code.plan.families.size()) {
            write_union(code, family, i);
        } else {
            write_minimum(code, family, i);
            write_minimum_gradient(code, family, i);
        }
        code.needs("leaf/family.glsl");
        code.out.families.push_back(family_table(code, family));
    }
}

}  // namespace shader
