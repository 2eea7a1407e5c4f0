// SPDX-License-Identifier: MIT
#include "bench/plain.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>

#include <fmt/format.h>

#include "bench/generated.h"
#include "bench/plain_parts.h"
#include "bench/report.h"
#include "field/overloaded.h"
#include "passes/differentiate.h"
#include "passes/pipeline.h"
#include "shader/assembly.h"
#include "shader/expression_glsl.h"

namespace bench {
namespace {

/// A shipped fractal: its shader, and the numbers of the preset.
struct Fractal {
    std::string_view preset, part, numbers;
};

constexpr std::array<Fractal, 7> fractals{{
    {"fractals/julia_default", "julia.glsl",
     "const int iterations = 11; const float slice = 0.0;\n"
     "const vec4 c = vec4(-0.2, 0.6, 0.2, 0.2);\n"},
    {"fractals/julia_dunes", "julia.glsl",
     "const int iterations = 10; const float slice = 0.0;\n"
     "const vec4 c = vec4(-0.45, -0.447, 0.181, 0.306);\n"},
    {"fractals/julia_lace", "julia.glsl",
     "const int iterations = 10; const float slice = 0.0;\n"
     "const vec4 c = vec4(-0.125, -0.256, 0.847, 0.0895);\n"},
    {"fractals/julia_spiral", "julia.glsl",
     "const int iterations = 12; const float slice = 0.0;\n"
     "const vec4 c = vec4(-0.291, -0.399, 0.339, 0.437);\n"},
    {"fractals/mandelbulb", "mandelbulb.glsl",
     "const int iterations = 10; const float power = 8.0;\n"},
    {"fractals/mandelbulb_power", "mandelbulb.glsl",
     "const int iterations = 8; const float power = 4.5;\n"},
    {"fractals/menger_sponge", "menger.glsl", "const int levels = 4;\n"},
}};

const Fractal* fractal_of(const Subject& subject) {
    const auto found = std::ranges::find(fractals, subject.name, &Fractal::preset);
    return found == fractals.end() ? nullptr : &*found;
}

/// All of a scene as one expression.
struct Whole {
    graph::NodeId value{};
    bool is_sheet = false;
};

/// Of formulas and their set operations: minimum, maximum and sign. Nothing if there is anything
/// else, or a sheet beside something.
std::optional<Whole> whole(const field::Field& field, field::FieldId id, graph::Graph& graph) {
    const auto pair = [&](const auto& node, graph::Op op) -> std::optional<Whole> {
        const auto a = whole(field, node.a, graph), b = whole(field, node.b, graph);
        if (!a || !b || a->is_sheet || b->is_sheet) return std::nullopt;
        return Whole{graph.apply(op, a->value, b->value), false};
    };
    return std::visit(
        field::Overloaded{
            [&](const field::Formula& leaf) -> std::optional<Whole> {
                return Whole{leaf.value, leaf.kind == field::Kind::sheet};
            },
            [&](const field::Union& node) { return pair(node, graph::Op::min); },
            [&](const field::Intersection& node) { return pair(node, graph::Op::max); },
            [&](const field::Complement& node) {
                auto inner = whole(field, node.a, graph);
                if (inner) inner->value = graph.apply(graph::Op::neg, inner->value);
                return inner;
            },
            [](const auto&) -> std::optional<Whole> { return std::nullopt; },
        },
        field[id]);
}

std::optional<Whole> whole(const Subject& subject, graph::Graph& graph) {
    return whole(subject.formula.field, subject.formula.field.root, graph);
}

std::string function(shader::ExpressionWriter& writer, std::string_view head,
                     std::span<const graph::NodeId> roots) {
    std::string text = fmt::format("{} {{\n{}", head, writer.statements(roots, "    "));
    if (roots.size() == 4) {
        text += fmt::format("    g = vec3({}, {}, {});\n", writer.spelling(roots[1]),
                            writer.spelling(roots[2]), writer.spelling(roots[3]));
    }
    return text + fmt::format("    return {};\n}}\n", writer.spelling(roots[0]));
}

/// The formula's functions, and the numbers that they and the template need.
struct Written {
    std::string functions, inverse_lipschitz;
    bool is_sheet = false;
    std::vector<shader::FieldValue> values;
    eval::Tape expressions;
};

Written write_formula(const Subject& subject) {
    graph::Graph graph = subject.formula.field.graph;
    const Whole all = *whole(subject, graph);
    const auto gradient = passes::gradient(graph, all.value);
    const auto roots =
        passes::run(graph, std::array{all.value, gradient[0], gradient[1], gradient[2]},
                    passes::Stage::evaluation);
    const std::vector<bool> depends = depends_on_variables(graph);
    shader::FieldValues values;
    const auto writer = [&] {
        return shader::ExpressionWriter(
            graph, depends, values,
            {{graph::variable_x, "p.x"}, {graph::variable_y, "p.y"}, {graph::variable_z, "p.z"}});
    };
    Written written;
    written.is_sheet = all.is_sheet;
    auto value_writer = writer(), gradient_writer = writer();
    written.functions = function(value_writer, "float f(vec3 p)", std::array{roots[0]});
    written.functions +=
        function(gradient_writer, "float f_and_gradient(vec3 p, out vec3 g)", roots);
    written.inverse_lipschitz =
        values.bound({shader::FieldValue::What::inverse_lipschitz, subject.formula.field.root, {}});
    written.values = values.list();
    written.expressions = eval::make_tape(graph, values.expressions());
    return written;
}

std::string with_formula(std::string text, const std::string& functions) {
    constexpr std::string_view mark = "// FORMULA\n";
    return text.replace(text.find(mark), mark.size(), functions);
}

/// The text before the estimate: what the frame is, what is written.
void add_start(shader::Assembly& assembly, const Subject& subject, const shader::Outputs& outputs) {
    assembly.add_code("#version 450 core\n");
    if (outputs.picture) {
        assembly.add_code("#define PICTURE\nlayout(location = 0) out vec4 picture_out;\n");
    }
    if (outputs.geometry) {
        assembly.add_code(
            "#define GEOMETRY\nlayout(location = 1) out vec4 geometry_out;\n"
            "layout(location = 2) out vec4 normal_out;\n");
    }
    assembly.add_part("common/real.glsl");
    assembly.add_part("common/frame_uniform.glsl");
    assembly.add_part("common/ray.glsl");
    const auto shape = subject.document.bounds.shape;
    assembly.add_part(shape == scene::Bounds::Shape::sphere ? "region/sphere.glsl"
                      : shape == scene::Bounds::Shape::box  ? "region/box.glsl"
                                                            : "region/none.glsl");
}

/// The text behind the estimate.
void add_end(shader::Assembly& assembly, const shader::Outputs& outputs) {
    assembly.add_code(plain_parts().at("picture.glsl"));
    if (outputs.picture) {
        assembly.add_code("const int zs_objects = 1;\n");
        assembly.add_part("material/of_object.glsl");
        assembly.add_part("light/light_uniform.glsl");
        assembly.add_part("light/blinn_phong.glsl");
        assembly.add_part("light/background.glsl");
        assembly.add_part("output/display.glsl");
    }
    assembly.add_code(plain_parts().at("main.glsl"));
}

}  // namespace

std::vector<std::string> plain_names(const Subject& subject) {
    if (fractal_of(subject)) return {std::string(plain_name)};
    if (generated_scene(subject.name)) return {};
    graph::Graph graph = subject.formula.field.graph;
    if (!whole(subject, graph)) return {};
    std::vector<std::string> names{std::string(plain_first_order_name)};
    shader::ProgramSource bound;
    bound.field_values = {
        {shader::FieldValue::What::inverse_lipschitz, subject.formula.field.root, {}}};
    if (compile::field_numbers(subject.formula, bound, subject.document).values[0] > 0) {
        names.insert(names.begin(), std::string(plain_sphere_name));
    }
    return names;
}

shader::ProgramSource plain_source(const Subject& subject, const std::string& name,
                                   const shader::Outputs& outputs) {
    shader::Assembly assembly, vertex;
    vertex.add_part("output/vertex.glsl");
    add_start(assembly, subject, outputs);
    Written written;
    if (name == plain_name) {
        const Fractal& fractal = *fractal_of(subject);
        assembly.add_code(fractal.numbers);
        assembly.add_code(plain_parts().find(fractal.part)->second);
    } else {
        written = write_formula(subject);
        assembly.add_code(fmt::format(
            "layout(std140, binding = 1) uniform Field {{ vec4 field_values[{}]; }};\n"
            "#define inverse_lipschitz {}\nconst bool is_sheet = {};\n",
            (written.values.size() + 3) / 4, written.inverse_lipschitz, written.is_sheet));
        assembly.add_code(plain_parts().at("operators.glsl"));
        const auto& text = plain_parts().at(name == plain_sphere_name ? "sphere_tracing.glsl"
                                                                      : "first_order.glsl");
        assembly.add_code(with_formula(text, written.functions));
    }
    add_end(assembly, outputs);
    return {vertex.text(), assembly.text(), std::move(written.values),
            std::move(written.expressions)};
}

}  // namespace bench
