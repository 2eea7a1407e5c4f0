// SPDX-License-Identifier: MIT
// A formula's parameters and a document's values for them: what fits, and which numbers come of it.
#pragma once

#include <vector>

#include "base/result.h"
#include "field/field.h"
#include "scene/document.h"

namespace compile {

/// What a document's value means to a parameter: one number a component, the index of a choice's
/// label, 1 or 0 of a toggle. Integers are rounded; ranges are those of sliders and limit nothing.
/// A problem's message says what must stand there and what does: "a number, not true".
base::Result<std::vector<double>> components(const field::Parameter& parameter,
                                             const scene::ParameterValue& value);

/// The parameter's components as the document has them, or by default: also where what the document
/// has does not fit.
std::vector<double> components_in(const scene::Document& document,
                                  const field::Parameter& parameter);

/// Puts components into the document, in the form that a preset shows: a label for a choice, true
/// or false for a toggle. Those by default are taken out instead.
void set_components(scene::Document& document, const field::Parameter& parameter,
                    const std::vector<double>& components);

/// Values of all of the graph's parameters: the time, then the components, from the document or
/// else by default. Names in the document that the formula does not have are ignored.
std::vector<double> parameter_values(const field::Field& field, const scene::Document& document);

/// What is wrong with the document's values: an error for each that does not fit its parameter, a
/// warning for each name that the formula does not have. With places where they are known.
base::Diagnostics check_parameters(const field::Field& field, const scene::ParameterValues& values,
                                   const scene::ParameterPlaces& places);

}  // namespace compile
