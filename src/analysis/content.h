// SPDX-License-Identifier: MIT
// What of a scene can be in a cell, by interval arithmetic on its whole tree.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "analysis/region.h"
#include "eval/tape.h"
#include "field/field.h"

namespace analysis {

/// What a cell may hold. Rigorous: of the real function and of its values in double.
struct Content {
    /// Encloses the signed value of the solids, below 0 inside; +infinity outside of domains, and
    /// where there are only sheets.
    numeric::Interval solid = numeric::infinity;
    bool sheet = false;  ///< a sheet may pass through

    bool proven_empty() const { return solid.lo > 0 && !sheet; }
    bool proven_full() const { return solid.hi <= 0; }
};

/// A node of the tree with all below it, for some parameter values, ready to look at many cells.
/// Escape-time iterations are followed turn by turn in intervals. Keeps a reference to the field.
class ContentFinder {
public:
    ContentFinder(const field::Field& field, field::FieldId id, std::span<const double> parameters);

    Content over(const Cell& cell);
    Content over(const std::array<numeric::Interval, 3>& sides);

    /// Operators that are evaluated for a cell, at most.
    std::size_t operations() const { return operations_; }

private:
    struct Loop {
        field::Iteration iteration;  ///< without what only its colour needs
        eval::Tape start, step, escape, distance;
        double limit = 0;
        bool poles = false;
    };
    struct Visitor;

    void prepare(field::FieldId id);
    void prepare(const field::Iteration& iteration, field::FieldId id);
    void prepare(const field::Cells& cells, field::FieldId id);
    std::span<const numeric::Interval> run(const eval::Tape& tape);
    double number(graph::NodeId id);
    numeric::Interval follow(const Loop& loop);
    Content content(field::FieldId id);

    const field::Field& field_;
    field::FieldId root_;
    std::vector<numeric::Interval> parameters_;
    std::vector<graph::NodeId> formulas_;  ///< roots of formula_tape_
    std::vector<bool> poles_;              ///< of each of them
    std::map<field::FieldId, std::size_t> formula_of_;
    std::map<field::FieldId, Loop> loops_;
    /// Of a blend: its value, its displacement if there is one; of a choice both sides of the
    /// condition; of cells the point within.
    std::map<field::FieldId, eval::Tape> tapes_;
    std::map<field::FieldId, std::unique_ptr<ContentFinder>> inside_;  ///< cells, by their node
    eval::Tape formula_tape_;
    std::size_t operations_ = 0;

    std::vector<numeric::Interval> formula_registers_, formula_values_;
    std::vector<numeric::Interval> variables_, scratch_, results_;
};

}  // namespace analysis
