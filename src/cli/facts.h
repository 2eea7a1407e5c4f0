// SPDX-License-Identifier: MIT
// The facts about a scene as text (`check --facts`) and as JSON (`check --json`).
#pragma once

#include <span>
#include <string>

#include "analysis/facts.h"
#include "compile/step_rules.h"
#include "graph/graph.h"

namespace cli {

/// For people: one aligned paragraph for the whole scene, and one for each object if there are
/// several.
std::string facts_text(const analysis::SceneFacts& facts, const graph::Graph& graph,
                       std::span<const compile::StepRule> rules);

/// One JSON object, indented, with a newline at the end.
std::string facts_json(const analysis::SceneFacts& facts, const graph::Graph& graph,
                       std::span<const compile::StepRule> rules);

}  // namespace cli
