// SPDX-License-Identifier: MIT
#include "shader/program_source.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "passes/recentre.h"
#include "shader/assembly.h"
#include "shader/field_glsl.h"

namespace shader {
namespace {

/// A tracer: its name, how far a formula lets a ray go, how far a ray goes then, and what it asks
/// of formulas (with intervals there are no strides).
struct Tracer {
    TracerName name;
    std::string_view step_part;
    std::string_view stride_part = "tracer/as_answered.glsl";
    Demands demands{};
};

constexpr std::array table{
    Tracer{{"auto",
            "certified steps from bounds of the first and second derivative, first order where "
            "those are too large (default)"},
           "step/auto.glsl",
           "tracer/as_answered.glsl",
           {.polynomials = true, .bricks = true}},
    Tracer{{"march",
            "steps of one length, the diagonal of the bounds over 7/8 of the steps: misses what is "
            "thinner"},
           "step/march.glsl",
           "tracer/fixed.glsl"},
    Tracer{{"sphere", "sphere tracing: the value over the region's Lipschitz constant"},
           "step/sphere.glsl"},
    Tracer{{"relaxed",
            "sphere tracing by steps that are 1.6 times as long, and back where two spheres part: "
            "as safe as 'sphere'"},
           "step/sphere.glsl",
           "tracer/relaxed.glsl"},
    Tracer{{"first-order", "the value over the gradient at the point: fast, may miss surfaces"},
           "step/first_order.glsl"},
    Tracer{{"second-order",
            "the distance by the gradient and the Hessian at the point: slower than the first "
            "order, misses less"},
           "step/second_order.glsl",
           "tracer/as_answered.glsl",
           {.hessians = true}},
    Tracer{{"interval",
            "bisection with intervals of the value and of its derivative along the ray, in single "
            "precision: slow, passes no surface; iterations, blends and copies by their distance"},
           "step/auto.glsl",
           {},
           {.intervals = true}},
};

const Tracer& tracer_of(std::string_view name) {
    const auto found = std::ranges::find(table, name, [](const Tracer& t) { return t.name.name; });
    return found == table.end() ? table[0] : *found;
}

/// Without bounds rays meet what no brick tells of.
bool skips_bricks(const Features& features) {
    const bool bounded = features.bounds_sphere || features.bounds_box;
    return features.skip_empty_bricks && bounded && !features.told_depth &&
           tracer_of(features.tracer).demands.bricks;
}

/// Whether rays go by the answers of a field alone, and those are balls.
bool goes_by_balls(const FieldGlsl& generated, const Tracer& tracer) {
    return generated.answers_balls && tracer.stride_part == "tracer/as_answered.glsl";
}

/// Polynomials along a ray need one of finite length, and more than one step on it; rounded in
/// single precision they tell nothing of what is as small as coordinates are recentred for.
Demands demands(const Tracer& tracer, const Features& features) {
    Demands result = tracer.demands;
    result.text_only = features.operands_as_text;
    const bool bounded = features.bounds_sphere || features.bounds_box;
    if (features.told_depth || !bounded || features.precision == Precision::recentred) {
        result.polynomials = false;
    }
    return result;
}

/// The part of shaders/ that finds the part of a tile's rays; empty: there is no pre-pass.
std::string_view prepass_part(const FieldGlsl& generated, const Tracer& tracer,
                              const Features& features) {
    if (features.whole_tiles) return "prepass/whole.glsl";
    if (skips_bricks(features)) return "prepass/bricks.glsl";
    // Estimates deep inside of zooms may be too large beside the axis of a cone.
    const bool zoomed = features.precision == Precision::doubled;
    if (features.told_depth || zoomed || !goes_by_balls(generated, tracer)) return "";
    return "prepass/cone.glsl";
}

bool certifies(const Features& features) {
    return features.show_certificate || features.outputs.certificate;
}

/// The fourth component of the normal output.
std::string_view told_of_ray(const Features& features) {
    if (!certifies(features)) {
        return features.outputs.count ? "float(primary_evaluations)" : "0.0";
    }
    return features.outputs.count ? "float(8 * primary_evaluations + certificate_of(hit.status))"
                                  : "float(certificate_of(hit.status))";
}

std::string outputs_code(const Features& features, bool prepass) {
    const Outputs& outputs = features.outputs;
    std::string declarations, body;
    const auto output = [&](int location, std::string_view name, std::string_view value) {
        declarations += fmt::format("layout(location = {}) out vec4 {}_out;\n", location, name);
        body += fmt::format("    {}_out = {};\n", name, value);
    };
    if (outputs.picture) output(0, "picture", "vec4(display(light), 1.0)");
    if (outputs.geometry) {
        body +=
            "    float depth = hit.status == zs_miss ? uintBitsToFloat(0x7f800000u) : "
            "float(hit.t);\n";
        output(1, "geometry",
               "vec4(depth, float(hit.steps), float(hit.status), float(hit.object))");
    }
    if (outputs.normal) output(2, "normal", fmt::format("vec4(n, {})", told_of_ray(features)));
    if (outputs.light) output(3, "light", "vec4(light, 1.0)");
    if (outputs.all())
        return declarations + "void write_pixel(Trace hit, real3 n, vec3 light) {\n" + body + "}\n";
    const std::string evaluations =
        outputs.count ? fmt::format("    int primary_evaluations = zs_evaluations{}{};\n",
                                    prepass ? " + tile_evaluations()" : "",
                                    certifies(features) ? " - zs_probes" : "")
                      : "";
    const std::string_view light =
        outputs.picture || outputs.light ? "    vec3 light = pixel_light(hit, o, d, n);\n" : "";
    return fmt::format("{}void write_pixel(Trace hit, real3 o, real3 d, real3 n) {{\n{}{}{}}}\n",
                       declarations, evaluations, light, body);
}

/// Distances of iterations are estimates.
bool has_estimates(const field::Field& field) {
    return std::ranges::any_of(field::leaves(field, field.root), [&](field::FieldId leaf) {
        return std::holds_alternative<field::Iteration>(field[leaf]);
    });
}

void add_certificate(Assembly& assembly, const field::Field& field, const FieldGlsl& generated,
                     const Features& features, bool prepass) {
    if (!certifies(features)) {
        assembly.add_part("tracer/no_certificate.glsl");
        return;
    }
    // What the coefficients of polynomials are off by is estimated.
    assembly.add_code(fmt::format(
        "const bool zs_estimates = {};\nconst bool zs_cones = {};\nconst bool zs_rounding = {};\n",
        has_estimates(field), prepass, !generated.polynomials.empty()));
    assembly.add_part("tracer/certificate.glsl");
}

/// Whether the frame's numbers come from the vertex shader: doubles are too many.
bool has_inputs(const Features& features) { return features.precision != Precision::doubled; }

/// Whether the lights and the material do.
bool lights_are_inputs(const Features& features) {
    return has_inputs(features) && features.few_lights &&
           (features.outputs.picture || features.outputs.light);
}

void add_picture_parts(Assembly& assembly, const Features& features, bool own_colours) {
    if (features.show_certificate || features.show_steps || features.show_normals) {
        assembly.add_part(features.show_certificate ? "output/certificate.glsl"
                          : features.show_steps     ? "output/steps.glsl"
                                                    : "output/normals.glsl");
        return;
    }
    assembly.add_part(features.shadows ? "light/soft_shadow.glsl" : "light/visibility_all.glsl");
    assembly.add_part(own_colours ? "material/of_point.glsl" : "material/of_object.glsl");
    assembly.add_part(lights_are_inputs(features) ? "light/light_input.glsl"
                                                  : "light/light_uniform.glsl");
    assembly.add_part("light/blinn_phong.glsl");
    assembly.add_part("light/background.glsl");
    assembly.add_part(features.grid ? "ground/grid.glsl" : "ground/none.glsl");
    assembly.add_part("output/shaded.glsl");
}

/// How many vectors hold the field's numbers.
std::size_t vectors(const FieldGlsl& generated) { return (generated.values.size() + 3) / 4; }

/// OpenGL promises room for 15 vectors between the stages only, but all hardware of its version 4
/// has some 30; the frame takes 14, the lights 5.
bool values_are_inputs(const FieldGlsl& generated, const Features& features) {
    constexpr std::size_t most_vectors = 11;
    return has_inputs(features) && vectors(generated) <= most_vectors;
}

/// Covers the picture, and hands the numbers on that are inputs of the fragment shaders.
std::string vertex_text(const FieldGlsl& generated, const Features& features) {
    Assembly assembly(features.precision);
    if (!has_inputs(features)) {
        assembly.add_part("output/vertex.glsl");
        return assembly.text();
    }
    assembly.add_part("output/triangle.glsl");
    assembly.add_part("common/real.glsl");
    const std::size_t count = vectors(generated);
    if (count > 0 && values_are_inputs(generated, features)) {
        assembly.add_code(
            fmt::format("layout(std140, binding = 1) uniform Field {{ vec4 values[{0}]; }} "
                        "field_block;\nflat out vec4 field_values[{0}];\n"
                        "void pass_field_values() {{ field_values = field_block.values; }}\n",
                        count));
    } else {
        assembly.add_code("void pass_field_values() {}\n");
    }
    if (lights_are_inputs(features)) {
        assembly.add_part("light/pass_light.glsl");
    } else {
        assembly.add_code("void pass_lights() {}\n");
    }
    assembly.add_part("output/vertex_with_frame.glsl");
    return assembly.text();
}

/// Numbers, the field's functions, and the bounds: what every program of a field begins with.
void add_field(Assembly& assembly, const FieldGlsl& generated, const Tracer& tracer,
               const Features& features) {
    assembly.add_code("#version 450 core\n");
    assembly.add_part("common/real.glsl");
    assembly.add_part(has_inputs(features) ? "common/frame_input.glsl"
                                           : "common/frame_uniform.glsl");
    assembly.add_part("common/ray.glsl");
    if (const std::size_t count = vectors(generated); count > 0) {
        if (values_are_inputs(generated, features)) {
            assembly.add_code(fmt::format("flat in vec4 field_values[{}];\n", count));
        } else {
            assembly.add_code(
                fmt::format("layout(std140, binding = 1) uniform Field {{ {}vec4 field_values[{}]; "
                            "}};\n",
                            features.precision == Precision::doubled ? "d" : "", count));
        }
    }
    assembly.add_code(generated.facts);
    assembly.add_part("common/answer.glsl");
    for (const std::string& part : generated.operator_parts) assembly.add_part(part);
    assembly.add_part(features.bounds_sphere || features.bounds_box ? "step/blind.glsl"
                                                                    : "step/blind_far.glsl");
    assembly.add_part(tracer.step_part);
    if (!generated.bricks.empty() || skips_bricks(features)) {
        assembly.add_code(
            fmt::format("const bool zs_has_bounds = {};\nconst int zs_scene_grid = {};\n",
                        features.bounds_sphere || features.bounds_box, generated.bricks.size()));
    }
    for (const std::string& part : generated.leaf_parts) assembly.add_part(part);
    if (tracer.demands.intervals) {
        assembly.add_code(fmt::format("const bool zs_may_be_empty = {};\n", generated.has_edges));
        assembly.add_part("interval/enclosure.glsl");
    }
    for (const std::string& part : generated.interval_parts) assembly.add_part(part);
    assembly.add_code(generated.code);
    assembly.add_part(features.bounds_sphere ? "region/sphere.glsl"
                      : features.bounds_box  ? "region/box.glsl"
                                             : "region/none.glsl");
}

void add_tracer(Assembly& assembly, const FieldGlsl& generated, const Tracer& tracer,
                const Features& features) {
    if (features.told_depth) return assembly.add_part("tracer/told.glsl");
    if (tracer.demands.intervals) return assembly.add_part("tracer/interval.glsl");
    if (goes_by_balls(generated, tracer)) return assembly.add_part("tracer/ball.glsl");
    assembly.add_part(tracer.stride_part);
    assembly.add_part(generated.is_regular ? "tracer/march.glsl" : "tracer/careful_march.glsl");
}

std::optional<BackgroundSource> background_source(Features features) {
    const bool measures = certifies(features) || features.show_steps || features.show_normals ||
                          features.told_depth || features.outputs.count;
    if (measures || !(features.bounds_sphere || features.bounds_box)) return std::nullopt;
    features.few_lights = false;
    Assembly assembly(features.precision);
    assembly.add_code("#version 450 core\n");
    assembly.add_part("common/real.glsl");
    assembly.add_part(has_inputs(features) ? "common/frame_input.glsl"
                                           : "common/frame_uniform.glsl");
    assembly.add_part("common/ray.glsl");
    assembly.add_part("light/background.glsl");
    assembly.add_part(features.grid ? "ground/grid.glsl" : "ground/none.glsl");
    assembly.add_part("output/behind.glsl");
    assembly.add_code(outputs_code(features, false));
    assembly.add_code(fmt::format(
        "void main() {{\n    real3 o = frame.eye.xyz, d = behind_direction(), n = real3(0.0);\n"
        "    write_pixel(nothing(), {});\n}}\n",
        features.outputs.all() ? "n, pixel_light(nothing(), o, d, n)" : "o, d, n"));
    return BackgroundSource{vertex_text({}, features), assembly.text(), features.bounds_box};
}

std::string prepass_text(const FieldGlsl& generated, const Tracer& tracer,
                         const Features& features) {
    Assembly assembly(features.precision);
    add_field(assembly, generated, tracer, features);
    assembly.add_part(prepass_part(generated, tracer, features));
    // What is kept is in single precision, and must leave out no more than was found.
    const bool rounds = features.precision == Precision::doubled;
    assembly.add_code(
        fmt::format("layout(location = 0) out vec4 tile_out;\n"
                    "void write_tile(real2 part) {{ tile_out = vec4(part{}, {}, 0.0); }}\n",
                    rounds ? " * real2(1.0 - 2e-7, 1.0 + 2e-7)" : "",
                    features.outputs.count ? "float(zs_evaluations)" : "0.0"));
    if (generated.needs_differences) assembly.add_part("normal/differences.glsl");
    assembly.add_part("prepass/main.glsl");
    return assembly.text();
}

}  // namespace

std::vector<TracerName> tracers() {
    std::vector<TracerName> names;
    for (const Tracer& tracer : table) names.push_back(tracer.name);
    return names;
}

ProgramSource program_source(const field::Field& field, const Features& features) {
    const Tracer& tracer = tracer_of(features.tracer);
    field::Field own = field;
    if (features.precision == Precision::recentred) passes::recentre(own);
    FieldGlsl generated =
        field_glsl(std::move(own), features.outputs.count, demands(tracer, features),
                   features.bricks, features.precision);
    const bool prepass = !prepass_part(generated, tracer, features).empty();
    Assembly assembly(features.precision);
    add_field(assembly, generated, tracer, features);
    assembly.add_part(prepass ? "prepass/part.glsl" : "prepass/none.glsl");
    add_certificate(assembly, field, generated, features, prepass);
    add_tracer(assembly, generated, tracer, features);
    if (generated.needs_differences) assembly.add_part("normal/differences.glsl");
    assembly.add_part("normal/normal.glsl");
    if (features.outputs.picture || features.outputs.light)
        add_picture_parts(assembly, features, generated.has_colours);
    assembly.add_code(outputs_code(features, prepass));
    assembly.add_part(features.outputs.all() ? "output/passes.glsl" : "output/fragment.glsl");
    std::string vertex = vertex_text(generated, features);
    std::string before = prepass ? prepass_text(generated, tracer, features) : std::string();
    return {std::move(vertex),
            assembly.text(),
            std::move(generated.values),
            std::move(generated.expressions),
            std::move(before),
            std::move(generated.bricks),
            skips_bricks(features),
            std::move(generated.polynomials),
            std::move(generated.families),
            std::move(generated.family_trees),
            features.precision,
            background_source(features)};
}

}  // namespace shader
