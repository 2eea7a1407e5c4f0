// SPDX-License-Identifier: MIT
// GLSL for expressions: one statement a node, but one for sine and cosine of the same argument.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "graph/graph.h"
#include "shader/precision.h"
#include "shader/program_source.h"

namespace shader {

/// A GLSL literal of type real: the shortest decimal that reads back the same. Finite values beyond
/// single precision become its largest there.
std::string literal(double value, Precision precision = Precision::single);

/// Gives each number that the CPU computes a place in the uniform block, and writes that place.
class FieldValues {
public:
    explicit FieldValues(Precision precision = Precision::single) : precision_(precision) {}

    Precision precision() const { return precision_; }
    std::string expression(graph::NodeId node);
    std::string bound(const FieldValue& value) { return place(value); }
    const std::vector<FieldValue>& list() const { return list_; }
    /// The nodes of those that are expressions, in their order.
    const std::vector<graph::NodeId>& expressions() const { return expressions_; }

private:
    std::string place(const FieldValue& value);

    Precision precision_;
    std::vector<FieldValue> list_;
    std::vector<graph::NodeId> expressions_;
    std::map<graph::NodeId, std::string> places_;
};

/// Writes the statements of one function's body.
class ExpressionWriter {
public:
    /// `depends` is graph::depends_on_variables; `variables` says how variables are spelt;
    /// `may_be_nan` is that of shader/domain.h, or nothing if everything may be.
    ExpressionWriter(const graph::Graph& graph, const std::vector<bool>& depends,
                     FieldValues& values, std::map<graph::VariableId, std::string> variables,
                     const std::vector<bool>* may_be_nan = nullptr)
        : graph_(graph),
          depends_(depends),
          may_be_nan_(may_be_nan),
          values_(values),
          names_(std::move(variables)) {}

    /// Statements that compute the roots and have not been written by this writer before, each
    /// after `indent`. Nodes that do not depend on variables are constants or field values.
    std::string statements(std::span<const graph::NodeId> roots, std::string_view indent);
    /// Says how a variable is spelt from now on.
    void name(graph::VariableId id, std::string spelling) { names_[id] = std::move(spelling); }
    /// How a root is spelt after its statements.
    std::string spelling(graph::NodeId id);
    /// What is known in the present scope; going back to it forgets what an inner scope wrote.
    using Scope = std::map<graph::NodeId, std::string>;
    const Scope& scope() const { return written_; }
    void return_to(Scope scope) { written_ = std::move(scope); }
    /// Says that a node has been written already, by another's hand.
    void know(graph::NodeId id, std::string spelling) { written_[id] = std::move(spelling); }

    /// The parts of shaders/operator/ that the statements so far need.
    const std::set<std::string>& operator_parts() const { return operator_parts_; }

private:
    /// The sine and the cosine of one argument, as far as both are to be written.
    struct WavePair {
        std::optional<graph::NodeId> sine, cosine;
    };

    /// Those nodes that the roots need and that have no statement yet.
    std::vector<graph::NodeId> open(std::span<const graph::NodeId> roots) const;
    std::string call(const graph::Node& node);
    /// The function that has the operator's values for the arguments that this node can have:
    /// GLSL's or a cheaper one where NaN and negative numbers cannot occur.
    std::string function(const graph::Node& node);

    const graph::Graph& graph_;
    const std::vector<bool>& depends_;
    const std::vector<bool>* may_be_nan_;
    FieldValues& values_;
    std::map<graph::VariableId, std::string> names_;
    Scope written_;
    int count_ = 0;
    std::set<std::string> operator_parts_;
};

}  // namespace shader
