// SPDX-License-Identifier: MIT
// What a program is fed with beside the frame: the numbers of its field.
#pragma once

#include <vector>

namespace shader {

/// The numbers of one frame that come from the formula and its parameters; made by compile/ for a
/// ProgramSource, handed over by render/.
struct FieldNumbers {
    std::vector<float> values;  ///< in the order of ProgramSource::field_values

    friend bool operator==(const FieldNumbers&, const FieldNumbers&) = default;
};

}  // namespace shader
