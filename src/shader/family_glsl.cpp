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

/// Where the list of the point's cell is.
std::string list_at_point(FieldCode& code, std::size_t i) {
    std::array<std::string, 8> head;
    for (std::size_t k = 0; k < head.size(); ++k) head[k] = code.families[i].heads[k];
    return fmt::format("family_list(p, real3({}, {}, {}), {}, real3({}, {}, {}), {})", head[0],
                       head[1], head[2], head[3], head[4], head[5], head[6], head[7]);
}

void write_union(FieldCode& code, const CodedFamily& family, std::size_t i) {
    code.out.code += fmt::format(
        "Answer family_{0}(real3 p) {{\n"
        "    ivec2 list = {1};\n"
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
        i, list_at_point(code, i), family.texels, family.texels - 1);
    code.needs("leaf/distance.glsl");
}

/// The minimum of those in the list, with its gradient on demand.
void write_minimum(FieldCode& code, const CodedFamily& family, std::size_t i, bool gradient) {
    const std::string width =
        family.it.width ? fmt::format(", {}", code.writer().spelling(*family.it.width)) : "";
    const std::string_view kind = family.it.width ? "smooth" : "plain";
    code.out.code += fmt::format(
        "real minimum_{0}(real3 p{5}) {{\n"
        "    ivec2 list = {1};\n"
        "    real f = zs_far;\n"
        "{6}"
        "    for (int at = list.x; at < list.y; at += {2}) {{\n"
        "{7}"
        "        f = {3}_minimum(f, member_{0}(p, at){4});\n"
        "    }}\n"
        "    return f;\n"
        "}}\n",
        i, list_at_point(code, i), family.texels, kind, width, gradient ? ", out real3 g" : "",
        gradient ? "    g = real3(0.0);\n" : "",
        gradient ? fmt::format("        g = mix(g, member_gradient_{0}(p, at), "
                               "{1}_weight(f, member_{0}(p, at){2}));\n",
                               i, kind, width)
                 : "");
    code.needs("leaf/minimum.glsl");
}

}  // namespace

std::string minima_statements(const FieldCode& code, std::size_t object, ExpressionWriter& writer,
                              bool gradients) {
    const auto found = code.minima.find(object);
    if (found == code.minima.end()) return {};
    std::string text;
    for (const auto& [variable, family] : found->second) {
        text +=
            gradients
                ? fmt::format("    real3 g_{0};\n    real f_{0} = minimum_{0}(p, g_{0});\n", family)
                : fmt::format("    real f_{0} = minimum_{0}(p);\n", family);
        writer.name(variable, fmt::format("f_{}", family));
    }
    return text;
}

void write_families(FieldCode& code) {
    for (std::size_t i = 0; i < code.families.size(); ++i) {
        CodedFamily& family = code.families[i];
        for (std::size_t k = 0; k < family.heads.size(); ++k) {
            family.heads[k] =
                code.values.bound({.what = FieldValue::What::family, .family = i, .component = k});
        }
        write_members(code, family, i);
        if (i < code.plan.families.size()) {
            write_union(code, family, i);
        } else {
            write_minimum(code, family, i, false);
            write_minimum(code, family, i, true);
        }
        code.needs("leaf/family.glsl");
        code.out.families.push_back(family_table(code, family));
    }
}

}  // namespace shader
