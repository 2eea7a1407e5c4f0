// SPDX-License-Identifier: MIT
// A field without iterations as one expression: what fields mean, spelt out a second time.
#pragma once

#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include "eval/tape.h"
#include "field/field.h"

namespace render_answers {

/// Evaluates the signed value of a field of solids in double precision, fast.
class FlatField {
public:
    /// No iterations may be below the root.
    FlatField(const field::Field& field, const std::vector<double>& parameters);

    double operator()(glm::dvec3 point);

private:
    eval::Tape tape_;
    std::vector<double> registers_;
};

}  // namespace render_answers
