// SPDX-License-Identifier: MIT
#include "contract/glsl_operator.h"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "graph/graph.h"
#include "render/canvas.h"
#include "render/program.h"
#include "shader/assembly.h"
#include "shader/expression_glsl.h"

namespace contract {
namespace {

/// Pixels of a canvas, one vec4 of the uniform block each: 16 KiB, which every OpenGL 4.5 has.
constexpr int side = 32;
constexpr std::size_t places_per_draw = side * side;

constexpr shader::Outputs geometry_only{
    .picture = false, .geometry = true, .normal = false, .count = false};

template <class T>
void report(const base::Result<T>& failed) {
    for (const base::Diagnostic& problem : failed.problems()) ADD_FAILURE() << problem.message;
}

}  // namespace

std::string operator_program(graph::Op op) {
    graph::Graph graph;
    const std::array<graph::VariableId, graph::max_arity> variables{
        graph::variable_x, graph::variable_y, graph::variable_z, graph.new_variable("w")};
    std::map<graph::VariableId, std::string> names;
    std::vector<graph::NodeId> arguments;
    for (int i = 0; i < graph::facts(op).arity; ++i) {
        const graph::VariableId id = variables[static_cast<std::size_t>(i)];
        names[id] = fmt::format("a.{}", "xyzw"[i]);
        arguments.push_back(graph.variable(id));
    }
    const graph::NodeId root = graph.apply(op, arguments);
    const std::vector<bool> depends = depends_on_variables(graph);
    shader::FieldValues values;
    shader::ExpressionWriter writer(graph, depends, values, names);
    const std::string statements = writer.statements(std::array{root}, "    ");

    shader::Assembly assembly;
    assembly.add_code("#version 450 core\n");
    assembly.add_part("common/real.glsl");
    assembly.add_code(
        fmt::format("layout(std140, binding = 1) uniform Field {{ vec4 field_values[{}]; }};\n"
                    "layout(location = 1) out vec4 geometry_out;\n",
                    places_per_draw));
    for (const std::string& part : writer.operator_parts()) assembly.add_part(part);
    assembly.add_code(
        fmt::format("void main() {{\n"
                    "    ivec2 pixel = ivec2(gl_FragCoord.xy);\n"
                    "    vec4 a = field_values[pixel.y * {} + pixel.x];\n"
                    "{}    geometry_out = vec4({}, 0.0, 0.0, 0.0);\n"
                    "}}\n",
                    side, statements, writer.spelling(root)));
    return assembly.text();
}

std::vector<float> glsl_values(const render::Context& context, graph::Op op,
                               std::span<const Arguments> places) {
    shader::Assembly vertex;
    vertex.add_part("output/vertex.glsl");
    const auto program =
        render::Program::link(context.gl(), {vertex.text(), operator_program(op), {}, {}});
    auto canvas = render::Canvas::create(context.gl(), side, side, geometry_only);
    report(program);
    report(canvas);
    if (!program || !canvas) return {};

    std::vector<float> results;
    std::vector<float> numbers(places_per_draw * graph::max_arity);
    while (!places.empty()) {
        const auto some = places.first(std::min(places.size(), places_per_draw));
        places = places.subspan(some.size());
        for (std::size_t i = 0; i < some.size(); ++i) {
            std::ranges::copy(some[i], numbers.begin() + static_cast<std::ptrdiff_t>(4 * i));
        }
        canvas->draw(*program, {}, numbers, {0, 0, side, side});
        const auto drawn = canvas->read_geometry();
        for (std::size_t i = 0; i < some.size(); ++i) {
            const int k = static_cast<int>(i);
            results.push_back(drawn.at(k % side, k / side)[0]);
        }
    }
    return results;
}

}  // namespace contract
