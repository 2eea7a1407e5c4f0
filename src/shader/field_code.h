// SPDX-License-Identifier: MIT
// What the writers of a field's functions share. Internal to the library.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "shader/expression_glsl.h"
#include "shader/field_glsl.h"
#include "shader/field_plan.h"

namespace shader {

/// Derivatives by x, y and z.
using Gradient = std::array<graph::NodeId, 3>;

/// Second derivatives: by x, y and z twice, by x and y, by x and z, by y and z.
using Hessian = std::array<graph::NodeId, 6>;

/// A family with what its functions are made of.
struct CodedFamily {
    Family it;
    std::vector<Gradient> gradients;  ///< of the kinds
    std::size_t first_object = 0;
    std::vector<field::FieldId> cells;  ///< around it, outermost first
    bool tells_objects = true;     ///< a member is an object; of a minimum in a formula it is none
    graph::VariableId variable{};  ///< that stands for a minimum
    std::size_t texels = 0;        ///< of a row
    std::string rows{};            ///< how GLSL spells where they begin
    std::vector<FamilyTable::Kind> tapes;  ///< of the kinds

    std::size_t kind_place() const { return 4 * texels - (tells_objects ? 2 : 1); }
    std::size_t last_object() const { return first_object + it.members.size() - 1; }
    /// The first texel of an object's row.
    std::string row(const std::string& object) const {
        return fmt::format("int({}) + {} * ({} - {})", rows, texels, object, first_object);
    }
    bool has_colours() const {
        return std::ranges::any_of(it.kinds, [](const MemberKind& kind) { return !!kind.colour; });
    }
};

/// A tree of cells for some of the families.
struct CodedTree {
    FamilyTree it;
    std::string cell{};  ///< GLSL for the cell that `p` is in
};

/// A field with all the derivatives that its program needs, and the code as it grows.
struct FieldCode {
    field::Field field;
    Demands demands;
    std::map<field::FieldId, Family> gathered;  ///< the unions that are families
    FieldPlan plan;
    /// As the plan numbers them, and then those of the minima in formulas.
    std::vector<CodedFamily> families;
    std::vector<CodedTree> trees;  ///< one a union, and then one for each leaf of `minima`
    /// By object, for formulas that are given by their outlines: the variables of minima and the
    /// numbers of their families.
    std::map<std::size_t, std::map<graph::VariableId, std::size_t>> minima;
    std::map<field::FieldId, std::map<graph::VariableId, graph::NodeId>> minima_weights;
    std::map<field::FieldId, Gradient> gradients;             ///< of formulas
    std::map<field::FieldId, Gradient> orbit_gradients;       ///< of iterations, of the last state
    std::map<field::FieldId, Hessian> hessians;               ///< of those that ask for one
    std::map<field::FieldId, std::array<Gradient, 3>> turns;  ///< of the points of cells
    std::map<field::FieldId, std::vector<Gradient>> wall_rates;       ///< of the walls of cells
    std::map<field::FieldId, std::vector<graph::NodeId>> weights;     ///< of a blend's operands
    std::map<field::FieldId, Gradient> displacements;                 ///< of blends that have one
    std::map<field::FieldId, std::vector<graph::NodeId>> jump_walls;  ///< of formulas
    std::map<field::FieldId, std::vector<Gradient>> jump_rates;       ///< of those
    std::map<std::size_t, std::vector<graph::NodeId>> along;          ///< of objects: coefficients
    std::array<graph::VariableId, 6> ray{};  ///< what those are made of: a point and a vector
    bool edges = false;                      ///< a formula may be undefined somewhere
    bool breaks = false;                     ///< a formula may jump or have a kink
    std::map<field::FieldId, graph::NodeId> rounding;  ///< bounds of formulas' rounding errors
    graph::VariableId position_error{};  ///< what those are made of: how far the point is off
    bool clips = false;                  ///< a sheet is cut by a solid, whose wall is no surface
    std::vector<bool> depends;
    std::vector<bool> nan;  ///< of each node whether it may be NaN
    FieldValues values;
    FieldGlsl out;

    FieldCode(field::Field of, const Demands& demands, Precision precision);

    const field::Formula* formula(std::size_t object) const {
        return std::get_if<field::Formula>(&field[plan.objects[object].id]);
    }
    const field::Iteration* iteration(std::size_t object) const {
        return std::get_if<field::Iteration>(&field[plan.objects[object].id]);
    }
    bool is_sheet(std::size_t object) const {
        return formula(object) && formula(object)->kind == field::Kind::sheet;
    }
    /// Whether the leaf answers with a distance that it has, not with one found by derivatives.
    bool is_distance(std::size_t object) const {
        return formula(object) && formula(object)->metric == field::Metric::distance &&
               !is_sheet(object);
    }
    /// Which grid of bricks the leaf is known by.
    std::optional<std::size_t> brick_grid(std::size_t object) const;
    /// Writes expressions of the point that GLSL calls `p`.
    ExpressionWriter writer(const std::string& p = "p");
    /// Keeps what the statements of a writer need.
    void finish(const ExpressionWriter& writer);
    /// A part of shaders/ that the code needs.
    void needs(const char* part) { out.leaf_parts.insert(part); }

private:
    void differentiate_orbits();
    void spell_out_orbits();
    void code_family(Family of, const std::vector<field::FieldId>& cells, std::size_t first_object,
                     bool tells_objects);
    void code_families();
    void code_minima();
    void differentiate();
    void differentiate_twice();
    void find_coefficients();
    void make_cheap();
    void bound_rounding();
};

/// The functions of the leaves: value_i, distance_i, leaf_i.
void write_leaves(FieldCode& code);

/// The functions of an object that is a polynomial along the ray: coefficients_i(c, e), those of s
/// for the point c + s e; leaf_i(s).
void write_polynomial(FieldCode& code, std::size_t object);

/// For each minimum in the value of an object: statements for its value and, on demand, its
/// gradient, before what is written of the object's formula.
std::string minima_statements(const FieldCode& code, std::size_t object, ExpressionWriter& writer,
                              bool gradients);

/// The answer of a far `cell`, if there are any.
std::string far_statement(const CodedTree& tree, std::size_t object);

/// The tree of an object's minima, if there are any.
const CodedTree* tree_of(const FieldCode& code, std::size_t object);

/// For each family: member_i and member_gradient_i by the row of a member, member_colour_i if one
/// has a colour; and family_i, the answer of the union, or minimum_i, with or without its gradient.
void write_families(FieldCode& code);
FamilyTable family_table(const FieldCode& code, const CodedFamily& family);

/// For each of plan.cells: cell_i (point, direction and way to the wall), cell_back_i (a gradient
/// in the cell's coordinates as one outside), cell_index_i.
void write_cells(FieldCode& code);

/// For each of plan.blends: blend_i, the value, the object that is nearest and about how fast the
/// value changes; blend_gradient_i, if no iteration is below.
void write_blends(FieldCode& code);

/// field(o, d, t), field_start, field_accept and field_forget. With intervals also part_k(p, d),
/// the answers of blends and cells with none above them, from left to right.
void write_tree(FieldCode& code, bool count_evaluations);

/// enclose(o, d, t): see field_glsl.h. What has no intervals (iterations, and blends and cells with
/// all that is below them) is asked at the near end.
void write_enclosures(FieldCode& code, bool count_evaluations);

/// object_gradient, and object_distance if it is needed.
void write_gradients(FieldCode& code);

/// object_is_zero, for fields whose formulas are smooth everywhere.
void write_rounding(FieldCode& code);

/// object_colour, if there are any.
void write_colours(FieldCode& code);

/// Statements that take the point `p` into these cells, outermost first; the names of the point
/// before each of them and at the end.
struct WayIn {
    std::string statements;
    std::vector<std::string> points;
};
WayIn way_in(const FieldCode& code, const std::vector<field::FieldId>& cells,
             const std::string& indent);

}  // namespace shader
