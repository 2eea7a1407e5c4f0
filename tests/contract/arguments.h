// SPDX-License-Identifier: MIT
// Where operators are looked at.
#pragma once

#include <random>
#include <vector>

#include "contract/operator_table.h"

namespace contract {

using Random = std::mt19937_64;

/// Numbers where arithmetic goes wrong, every one of them single-precision: zeros, ones, neighbours
/// of ones, halves, multiples of pi / 2, denormal, tiny, huge and infinite ones, and NaN.
const std::vector<float>& awkward_numbers();

/// All combinations of awkward numbers for operators of one or two arguments, many random ones for
/// more.
std::vector<Arguments> awkward_arguments(int arity, Random& random);

/// A number of the range: any magnitude, any place, near an end, whole, or near an awkward number.
float random_number(const Range& range, Random& random);
std::vector<Arguments> random_arguments(const Row& row, std::size_t count, Random& random);

}  // namespace contract
