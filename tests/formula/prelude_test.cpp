// SPDX-License-Identifier: MIT
#include "formula/prelude.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>
#include <vector>

#include "formula/built_in.h"
#include "formula/lowering.h"
#include "formula/mentions.h"
#include "formula/understood.h"

namespace formula {
namespace {

void check(std::string_view text, std::string_view errors) {
    EXPECT_EQ(errors_of(text), errors) << "formula: " << text;
}

TEST(Prelude, is_parsed_by_many_threads_at_once) {
    std::vector<std::thread> threads;
    std::vector<std::size_t> parameters(8);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        threads.emplace_back([&parameters, i] {
            for (const std::string_view name : prelude_names()) {
                parameters[i] += prelude_function(name).definition->parameters->size();
            }
        });
    }
    for (std::thread& it : threads) it.join();
    EXPECT_GT(parameters[0], 0u);
    for (const std::size_t it : parameters) EXPECT_EQ(it, parameters[0]);
}

TEST(Prelude, has_one_function_a_file_which_uses_all_its_parameters) {
    EXPECT_TRUE(std::ranges::is_sorted(prelude_names()));
    for (const std::string_view name : prelude_names()) {
        const FunctionValue& function = prelude_function(name);
        EXPECT_EQ(function.name, name);
        EXPECT_FALSE(prelude_summary(name).empty()) << name;
        const Definition& definition = *function.definition;
        const Mentions names = mentions(function.source->program, definition.value);
        for (const FunctionParameter& it : *definition.parameters) {
            EXPECT_TRUE(names.contains(it.name)) << name << ' ' << it.name;
        }
    }
}

TEST(Prelude, of_fields_without_required_arguments_is_good) {
    for (const std::string_view name : prelude_names()) {
        const auto& parameters = *prelude_function(name).definition->parameters;
        const bool required =
            std::ranges::any_of(parameters, [](const auto& it) { return !it.initial; });
        if (!required) {
            EXPECT_EQ(report_of(std::string(name) + "()"), "") << name;
        }
    }
}

TEST(Prelude, is_called_like_what_is_built_in) {
    EXPECT_DOUBLE_EQ(value_at("ellipsoid()", {0, 1.4, 0}), 1);
    EXPECT_DOUBLE_EQ(value_at("ellipsoid(2)", {4, 0, 0}), 1);
    EXPECT_DOUBLE_EQ(value_at("param k = 2\nellipsoid(c = k, a = 1)", {0, 0, 4}), 1);
    EXPECT_DOUBLE_EQ(value_at("e = ellipsoid\nx = 3 | e(2)", {4, 0, 0}), 1);
    EXPECT_EQ(signature("ellipsoid"), "ellipsoid(a = 1, b = 0.7, c = 0.5)");
    EXPECT_EQ(prelude_summary("ellipsoid"), "An ellipsoid by its half axes along x, y and z.");
}

TEST(Prelude, knows_nothing_of_the_names_of_the_text) {
    EXPECT_DOUBLE_EQ(value_at("hypot = 3\na = 5\nellipsoid(b = a + hypot)", {2, 0, 0}), 1);
}

TEST(Prelude, has_errors_at_the_call) {
    check("ellipsoid(x)", "1:11: the argument 'a' of 'ellipsoid' must not depend on x, y or z");
    check("ellipsoid((1, 2))", "1:11: the argument 'a' of 'ellipsoid' is one number, not a tuple");
    check("ellipsoid(sphere(1))", "1:11: the argument 'a' of 'ellipsoid' is a number, not a field");
    check("ellipsoid(1/0)", "1:11: the argument 'a' of 'ellipsoid' is not a finite number");
    check("ellipsoid(r = 1)",
          "1:11: 'ellipsoid' has no argument 'r'; it is called 'ellipsoid(a = 1, "
          "b = 0.7, c = 0.5)'");
    check("ellipsoid(1, 2, 3, 4)",
          "1:1: 'ellipsoid' takes at most 3 arguments, not 4; it is called 'ellipsoid(a = 1, b = "
          "0.7, c = 0.5)'");
    check("elipsoid()", "1:1: unknown name 'elipsoid'; did you mean 'ellipsoid'?");
    check("ellipsoid + 1",
          "1:1: 'ellipsoid' needs its arguments in brackets; it is called "
          "'ellipsoid(a = 1, b = 0.7, c = 0.5)'");
    check("call(f, a) = f(a)\ncall(ellipsoid, (1, 2))",
          "1:16: the argument 'a' of 'ellipsoid' is one number, not a tuple (in the call of 'call' "
          "on line 2)");
}

}  // namespace
}  // namespace formula
