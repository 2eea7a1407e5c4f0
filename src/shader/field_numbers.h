// SPDX-License-Identifier: MIT
// What a program is fed with beside the frame: the numbers of its field.
#pragma once

#include <array>
#include <memory>
#include <vector>

namespace shader {

/// Bounds of formulas brick by brick, as shaders/brick/brick.glsl reads them: a grid of side^3
/// pairs for each of ProgramSource::bricks, one above the other; then one for the whole scene if
/// ProgramSource::scene_bricks.
struct BrickTexels {
    int side = 1;
    int grids = 1;
    std::vector<float> texels;  ///< two for each brick, x fastest

    friend bool operator==(const BrickTexels&, const BrickTexels&) = default;
};

/// The numbers of one frame that come from the formula and its parameters; made by compile/ for a
/// ProgramSource, handed over by render/.
struct FieldNumbers {
    /// In the order of ProgramSource::field_values; rounded to what the program calculates with.
    std::vector<double> values;
    std::shared_ptr<const BrickTexels> bricks;  ///< none if the program uses none
    double brick_seconds = 0;                   ///< what finding them took; not compared
    /// Bounds are as sure as ever, but with more time they would be closer; not compared.
    bool coarse = false;
    /// The origin of the program's coordinates in the world.
    std::array<double, 3> origin{};
    /// The texels of families (shader/family_table.h), four numbers each; nothing without families.
    std::shared_ptr<const std::vector<float>> families{};

    friend bool operator==(const FieldNumbers& a, const FieldNumbers& b) {
        const auto same = [](const auto& one, const auto& other) {
            return one == other || (one && other && *one == *other);
        };
        return a.values == b.values && a.origin == b.origin && same(a.bricks, b.bricks) &&
               same(a.families, b.families);
    }
};

}  // namespace shader
