// SPDX-License-Identifier: MIT
#include "cli/emit_passes.h"

#include <fmt/format.h>

#include "field/print_field.h"
#include "formula/lower.h"
#include "passes/operation_count.h"
#include "passes/pipeline.h"

namespace cli {
namespace {

passes::OperationCount count(const field::Field& field) {
    field::Field copy = field;
    std::vector<graph::NodeId> roots;
    for (const graph::NodeId* place : passes::all_expressions(copy)) roots.push_back(*place);
    return passes::count_operations(field.graph, roots);
}

std::string operations(std::size_t n) {
    return fmt::format("{} operation{}", n, n == 1 ? "" : "s");
}

/// "5 operations: 2 add, 3 mul"
std::string in_words(const passes::OperationCount& count) {
    std::string text = operations(count.at_points);
    const char* before = ": ";
    graph::for_each_operator([&](graph::Op op) {
        const std::size_t n = count.by_operator[static_cast<std::size_t>(op)];
        if (n == 0) return;
        text += fmt::format("{}{} {}", before, n, facts(op).name);
        before = ", ";
    });
    return text;
}

}  // namespace

base::Result<std::string> emit_passes(std::string_view formula) {
    auto lowered = formula::understand(formula);
    if (!lowered) return lowered.problems();
    field::Field& field = lowered->field;
    std::string now = field::print(field);
    std::string text = fmt::format("lowered, {}\n{}", in_words(count(field)), now);
    for (const passes::Stage stage : {passes::Stage::meaning, passes::Stage::evaluation}) {
        passes::run(field, stage, [&](const passes::Pass& pass, const field::Field& after) {
            std::string next = field::print(after);
            text += next == now ? fmt::format("after '{}' the same\n", pass.name)
                                : fmt::format("\nafter '{}', {}\n{}", pass.name,
                                              in_words(count(after)), next);
            now = std::move(next);
        });
    }
    const passes::OperationCount last = count(field);
    text += fmt::format("\nat each point {}\nonce a frame {}\n", in_words(last),
                        operations(last.hoisted));
    return text;
}

}  // namespace cli
