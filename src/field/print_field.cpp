// SPDX-License-Identifier: MIT
#include "field/print_field.h"

#include <string_view>
#include <utility>

#include "graph/print.h"

namespace field {
namespace {

using graph::NodeId;

/// A node to print, how deep in the tree.
struct Entry {
    FieldId id{};
    int depth = 0;
};

/// Named expressions, printed as one graph.
std::string expressions(const graph::Graph& graph,
                        const std::vector<std::pair<std::string, NodeId>>& list,
                        const std::string& indent) {
    std::vector<NodeId> roots;
    for (const auto& [name, id] : list) roots.push_back(id);
    std::vector<std::string> names;
    const std::string body = print(graph, roots, &names);
    std::string text;
    for (std::string_view rest = body; !rest.empty();) {
        const std::size_t end = rest.find('\n') + 1;
        text += indent;
        text += rest.substr(0, end);
        rest.remove_prefix(end);
    }
    for (std::size_t i = 0; i < list.size(); ++i) {
        text += indent + list[i].first + ": " + names[i] + '\n';
    }
    return text;
}

void add_colour(std::vector<std::pair<std::string, NodeId>>& list,
                const std::optional<Colour>& colour) {
    if (!colour) return;
    list.emplace_back("red", (*colour)[0]);
    list.emplace_back("green", (*colour)[1]);
    list.emplace_back("blue", (*colour)[2]);
}

struct Printer {
    const Field& field;
    std::string indent;
    std::vector<FieldId> children{};

    using Expressions = std::vector<std::pair<std::string, NodeId>>;

    static void add_point(Expressions& list, const std::string& name, const Point& point) {
        for (std::size_t i = 0; i < 3; ++i) list.emplace_back(name + " " + "xyz"[i], point[i]);
    }

    static void add_image(Expressions& list, const Image& image) {
        add_point(list, "image", image.point);
        if (image.turn) list.emplace_back("turn", *image.turn);
    }

    std::string operator()(const Formula& leaf) const {
        const std::string kind = leaf.kind == Kind::sheet ? "sheet" : "solid";
        const std::string metric = leaf.metric == Metric::distance ? " distance" : "";
        Expressions list{{"value", leaf.value}};
        for (const Distortion& it : leaf.distortions) {
            add_image(list, it.image);
            if (it.displacement) list.emplace_back("displacement", *it.displacement);
        }
        add_colour(list, leaf.colour);
        return kind + metric + '\n' + expressions(field.graph, list, indent + "  ");
    }
    std::string operator()(const Iteration& leaf) const {
        Expressions list;
        for (std::size_t i = 0; i < leaf.state.size(); ++i) {
            const std::string& name = field.graph.name(leaf.state[i]);
            list.emplace_back("start " + name, leaf.start[i]);
            list.emplace_back("step " + name, leaf.step[i]);
        }
        list.emplace_back("limit", leaf.limit);
        if (leaf.escape) list.emplace_back("escape", *leaf.escape);
        list.emplace_back("distance", leaf.distance);
        if (leaf.image) add_image(list, *leaf.image);
        add_colour(list, leaf.colour);
        return "iteration\n" + expressions(field.graph, list, indent + "  ");
    }
    std::string operator()(const Union& node) { return inner("union", {node.a, node.b}); }
    std::string operator()(const Intersection& node) {
        return inner("intersection", {node.a, node.b});
    }
    std::string operator()(const Complement& node) { return inner("complement", {node.a}); }
    std::string operator()(const Blend& node) {
        Expressions list{{"value", node.value}};
        if (node.displacement) list.emplace_back("displacement", *node.displacement);
        return inner("blend", node.operands) + expressions(field.graph, list, indent + "  ");
    }
    std::string operator()(const Choice& node) {
        return inner("choice", {node.a, node.b}) +
               expressions(field.graph, {{"less", node.less}, {"than", node.than}}, indent + "  ");
    }
    std::string operator()(const Cells& node) {
        Expressions list;
        add_point(list, "point", node.point);
        for (const NodeId wall : node.walls) list.emplace_back("wall", wall);
        for (const NodeId number : node.index) list.emplace_back("index", number);
        add_colour(list, node.colour);
        return inner("cells", {node.a}) + expressions(field.graph, list, indent + "  ");
    }
    std::string inner(const char* name, std::vector<FieldId> below) {
        children = std::move(below);
        return std::string(name) + '\n';
    }
};

}  // namespace

std::string print(const Field& field) {
    std::string text;
    std::vector<Entry> open{{field.root, 0}};
    while (!open.empty()) {
        const Entry entry = open.back();
        open.pop_back();
        Printer printer{field, std::string(static_cast<std::size_t>(entry.depth) * 2, ' ')};
        text += printer.indent + std::visit(printer, field[entry.id]);
        for (std::size_t i = printer.children.size(); i-- > 0;) {
            open.push_back({printer.children[i], entry.depth + 1});
        }
    }
    return text;
}

}  // namespace field
