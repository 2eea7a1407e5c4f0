// SPDX-License-Identifier: MIT
// How the steps at each object are found, as JSON.
#pragma once

#include <span>

#include <nlohmann/json_fwd.hpp>

#include "compile/step_rules.h"

namespace cli {

/// A list with an object for each rule.
nlohmann::ordered_json step_rules_json(std::span<const compile::StepRule> rules);

}  // namespace cli
