// SPDX-License-Identifier: MIT
// GLSL that encloses expressions over intervals: one statement a node. Internal to the library.
#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "shader/expression_glsl.h"

namespace shader {

/// Writes statements that enclose expressions, for variables that are intervals. Rigorous as far as
/// the functions of shaders/interval/ are.
class IntervalWriter {
public:
    /// As for ExpressionWriter; the variables' names are those of intervals.
    IntervalWriter(const graph::Graph& graph, const std::vector<bool>& depends, FieldValues& values,
                   std::map<graph::VariableId, std::string> variables)
        : graph_(graph), depends_(depends), values_(values), names_(std::move(variables)) {}

    /// Statements for those nodes that the root needs and that this writer has not written yet.
    std::string statements(graph::NodeId root, std::string_view indent);
    /// How the interval of a root is spelt after its statements.
    std::string spelling(graph::NodeId id);
    /// The parts of shaders/interval/ that the statements so far need.
    const std::set<std::string>& parts() const { return parts_; }

private:
    std::string call(const graph::Node& node);
    std::string function(std::string_view name);

    const graph::Graph& graph_;
    const std::vector<bool>& depends_;
    FieldValues& values_;
    std::map<graph::VariableId, std::string> names_;
    std::map<graph::NodeId, std::string> written_;
    std::set<std::string> parts_;
};

}  // namespace shader
