// SPDX-License-Identifier: MIT
#include "contract/glsl_values.h"

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

std::optional<std::string> expression_program(const graph::Graph& graph,
                                              std::span<const graph::NodeId> roots,
                                              shader::Precision precision) {
    std::map<graph::VariableId, std::string> names;
    for (std::size_t i = 0; i < std::min<std::size_t>(4, graph.variable_count()); ++i) {
        names[static_cast<graph::VariableId>(i)] = fmt::format("a.{}", "xyzw"[i]);
    }
    const std::vector<bool> depends = depends_on_variables(graph);
    shader::FieldValues values(precision);
    shader::ExpressionWriter writer(graph, depends, values, names);
    const std::string statements = writer.statements(roots, "    ");
    std::array<std::string, 4> results{"0.0", "0.0", "0.0", "0.0"};
    std::ranges::transform(roots, results.begin(),
                           [&](graph::NodeId root) { return writer.spelling(root); });
    if (!values.list().empty()) return std::nullopt;

    const bool doubled = precision == shader::Precision::doubled;
    shader::Assembly assembly(precision);
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
                    "    real4 a = field_values[pixel.y * {} + pixel.x];\n{}",
                    side, statements));
    assembly.add_code(
        doubled ? fmt::format(
                      "    real first = real(float({0}));\n"
                      "    real second = real(float({0} - first));\n"
                      "    geometry_out = vec4(first, second, {0} - first - second, 0.0);\n}}\n",
                      results[0])
                : fmt::format("    geometry_out = vec4({});\n}}\n", fmt::join(results, ", ")));
    return assembly.text();
}

std::string operator_program(graph::Op op, shader::Precision precision) {
    graph::Graph graph;
    const std::array<graph::VariableId, graph::max_arity> variables{
        graph::variable_x, graph::variable_y, graph::variable_z, graph.new_variable("w")};
    std::vector<graph::NodeId> arguments;
    for (int i = 0; i < graph::facts(op).arity; ++i) {
        arguments.push_back(graph.variable(variables[static_cast<std::size_t>(i)]));
    }
    return *expression_program(graph, std::array{graph.apply(op, arguments)}, precision);
}

std::vector<std::array<float, 4>> glsl_values(const render::Context& context,
                                              const std::string& program_text,
                                              std::span<const Arguments> places) {
    shader::Assembly vertex;
    vertex.add_part("output/vertex.glsl");
    const auto program = render::Program::link(context.gl(), {vertex.text(), program_text, {}, {}});
    auto canvas = render::Canvas::create(context.gl(), side, side, geometry_only);
    report(program);
    report(canvas);
    if (!program || !canvas) return {};

    std::vector<std::array<float, 4>> results;
    std::vector<double> values(places_per_draw * graph::max_arity);
    while (!places.empty()) {
        const auto some = places.first(std::min(places.size(), places_per_draw));
        places = places.subspan(some.size());
        for (std::size_t i = 0; i < some.size(); ++i) {
            std::ranges::copy(some[i], values.begin() + static_cast<std::ptrdiff_t>(4 * i));
        }
        shader::FieldNumbers numbers;
        numbers.values = values;
        canvas->draw(*program, {}, numbers, {0, 0, side, side});
        const auto drawn = canvas->read_geometry();
        for (std::size_t i = 0; i < some.size(); ++i) {
            const int k = static_cast<int>(i);
            const float* const pixel = drawn.at(k % side, k / side);
            results.push_back({pixel[0], pixel[1], pixel[2], pixel[3]});
        }
    }
    return results;
}

}  // namespace contract
