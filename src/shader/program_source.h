// SPDX-License-Identifier: MIT
// The text of a program that draws a scene, joined from the field's generated functions and the
// parts of shaders/ that the scene uses.
#pragma once

#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "eval/tape.h"
#include "field/field.h"
#include "shader/family_table.h"
#include "shader/precision.h"

namespace shader {

/// What the program writes for each pixel, each into its own colour attachment:
/// picture (location 0) sRGB-encoded colour, alpha 1;
/// geometry (location 1) depth along the unit ray in world units (+infinity for a miss), steps of
/// the primary ray, status (see Status), object id or -1;
/// normal (location 2) unit normal facing the eye, 0 for a miss; and evaluations of the field,
/// or, with certificates, 8 times as much and a Certificate;
/// light (location 3) linear light before exposure and transfer function. A program that writes all
/// four can also begin with a later pass, from what an earlier frame has left in textures 2 to 4
/// (shaders/output/passes.glsl).
struct Outputs {
    bool picture = true;
    bool geometry = false;
    bool normal = false;
    bool count = false;  ///< count the evaluations of primary rays: slower
    bool light = false;
    bool certificate = false;  ///< tell what the primary ray proves: slower

    /// Whether a program can begin with a later pass.
    bool all() const { return picture && geometry && normal && light && !count; }

    friend bool operator==(const Outputs&, const Outputs&) = default;
};

/// The third component of the geometry output.
enum class Status { miss = 0, hit = 1, unresolved = 2 };

/// What the primary ray of a pixel proves, up to the rounding of single precision.
enum class Certificate {
    proven_hit = 0,   ///< no step was longer than proven, and the surface is between two sides
    proven_miss = 1,  ///< no step was longer than proven
    hit_within_rounding = 2,   ///< the same up to epsilon of a pixel, or by rounded coefficients
    miss_within_rounding = 3,  ///< likewise
    heuristic_hit = 4,         ///< found by steps that are guesses or estimates
    heuristic_miss = 5,        ///< likewise
    unresolved = 6,            ///< out of steps
};
inline constexpr int certificate_count = 7;
/// What the fourth component of a normal output with certificates says.
inline Certificate certificate_in(float told) {
    return static_cast<Certificate>(static_cast<long long>(told) % 8);
}
inline double evaluations_in(float told) { return std::floor(told / 8); }

/// What is switched on, as far as it changes the program.
struct Features {
    std::string tracer = "auto";
    Precision precision = Precision::single;
    bool bounds_sphere = true;  ///< otherwise bounds_box, or none
    bool bounds_box = false;
    bool shadows = true;
    bool grid = false;
    bool few_lights = false;  ///< at most two, and one material: faster
    bool show_steps = false;
    bool show_certificate = false;
    /// For measuring: colour the normal, or follow no ray but be told its depth (tracer/told.glsl).
    bool show_normals = false;
    bool told_depth = false;
    /// For testing: a pre-pass that leaves all rays as they are.
    bool whole_tiles = false;
    /// Formulas in no cells and no blends whose bounds are known brick by brick; used by tracers
    /// that go by those bounds.
    std::vector<field::FieldId> bricks{};
    /// Skip what of rays lies in bricks that hold nothing of the scene.
    bool skip_empty_bricks = false;
    /// Also for measuring: the operands of large unions as text, one after the other.
    bool operands_as_text = false;
    Outputs outputs;

    friend bool operator==(const Features&, const Features&) = default;
};

/// A number that the CPU computes from the parameters and hands to the program.
struct FieldValue {
    enum class What {
        expression,         ///< the next root of ProgramSource::expressions
        inverse_lipschitz,  ///< 1 / the Lipschitz constant over the region; 0 if unbounded
        second_derivative,  ///< sup |d2f/dt2| of the leaf over the region; negative if unbounded
        first_order,        ///< 1 where the leaf is stiff: the first-order step is used, else 0
        family,             ///< the FamilyHead that `component` numbers, of one of the families
    };
    What what = What::expression;
    field::FieldId node{};  ///< a leaf or a blend, unless it is an expression
    /// The cells that the node is in, outermost first: the region is seen in their coordinates.
    std::vector<field::FieldId> cells{};
    std::size_t family = 0, component = 0;
};

/// A program for the pixels whose rays do not meet the bounds: it writes what the scene's program
/// would, for less. The same for all fields.
struct BackgroundSource {
    std::string vertex, fragment;
    bool bounds_box = false;  ///< otherwise they are a sphere
};

struct ProgramSource {
    std::string vertex;
    std::string fragment;
    /// In the order of the uniform block's floats (`field_values`, four to a vec4).
    std::vector<FieldValue> field_values;
    /// What does not depend on the point, computed once a frame from the parameters.
    eval::Tape expressions{};
    /// The fragment shader of the pre-pass, or empty. It writes for each tile of 8x8 pixels of the
    /// full picture the part [t0, t1] of rays outside of which no ray of the tile meets a surface,
    /// and how often it has asked the field (if that is counted); `fragment` reads that from
    /// texture 1.
    std::string prepass{};
    /// Formulas whose bounds are read brick by brick, in the order of BrickTexels's grids.
    std::vector<field::FieldId> bricks{};
    /// Whether there is one more grid, of bricks in which nothing of the scene is.
    bool scene_bricks = false;
    /// Objects (leaves from left to right) that are walked as polynomials along the ray.
    std::set<std::size_t> polynomials{};
    std::vector<FamilyTable> families{};
    std::vector<FamilyTree> family_trees{};
    /// Says in which numbers the uniform blocks are, and about which origin.
    Precision precision = Precision::single;
    /// None without bounds, and where more is counted or shown than the picture.
    std::optional<BackgroundSource> background{};

    /// Whether both are the same program; its numbers are the same then too.
    bool same_text(const ProgramSource& other) const {
        return fragment == other.fragment && prepass == other.prepass && vertex == other.vertex;
    }
};

/// The pixels of a tile of the pre-pass, along each side (shaders/prepass/tile.glsl).
inline constexpr int tile_side = 8;

/// Names of tracers for Features::tracer, with a sentence each for help.
struct TracerName {
    std::string_view name;
    std::string_view summary;
};
std::vector<TracerName> tracers();

/// The program's text. Deterministic. The field must have passed through the passes.
ProgramSource program_source(const field::Field& field, const Features& features);

}  // namespace shader
