// SPDX-License-Identifier: MIT
#include "formula/apply.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "formula/understood.h"

namespace formula {
namespace {

/// The messages of what is done while a text is lowered.
std::string errors_while(std::string_view text,
                         const std::function<void(Lowering&, ExpressionId)>& act) {
    const base::Result<Program> program = parse(text);
    if (!program) return errors_of(text);
    const Source source{*program, text};
    Scope scope;
    Lowering lowering{&source, &scope};
    act(lowering, program->result);
    std::string list;
    for (const base::Diagnostic& it : lowering.errors) {
        list += (list.empty() ? "" : "\n") + it.message;
    }
    return list;
}

std::string call(const std::string& function, std::size_t count) {
    return errors_while("x", [&](Lowering& lowering, ExpressionId id) {
        const graph::NodeId one = lowering.field.graph.constant(1);
        const std::vector<Value> arguments(count, Value(one));
        apply(lowering, FunctionValue{function}, lowering.span(id), arguments);
    });
}

TEST(Apply, calls_what_is_built_in_by_its_name) {
    EXPECT_EQ(call("sin", 1), "");
    EXPECT_EQ(call("atan2", 2), "");
}

TEST(Apply, refuses_what_cannot_take_the_arguments) {
    EXPECT_EQ(call("offset", 2),
              "'offset' is called with fields; it cannot be used as a function of numbers or "
              "vectors");
    for (const std::string field : {"sphere", "julia"}) {
        EXPECT_EQ(call(field, 1), "'" + field +
                                      "' gives a field; it cannot be used as a function of "
                                      "numbers or vectors");
    }
    EXPECT_EQ(call("dot", 1), "'dot' cannot be called with 1 argument; it is called 'dot(a, b)'");
    EXPECT_EQ(call("conj", 2), "'conj' cannot be called with 2 arguments; it is called 'conj(q)'");
}

TEST(Apply, finds_functions_by_their_name_alone) {
    const auto error = [](std::string_view text) {
        return errors_while(text, [](Lowering& lowering, ExpressionId id) {
            as_function(lowering, id, "a map of space");
        });
    };
    EXPECT_EQ(error("sin"), "");
    EXPECT_EQ(error("foo"), "unknown name 'foo'");
    EXPECT_EQ(error("2"), "a number is no function, so it cannot be a map of space");
    EXPECT_EQ(error("(1, 2)"), "a vector of 2 is no function, so it cannot be a map of space");
}

}  // namespace
}  // namespace formula
