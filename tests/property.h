// SPDX-License-Identifier: MIT
// Runs a RapidCheck property as a part of a test.
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/detail/TestListenerAdapter.h>

#include <cstdint>
#include <sstream>
#include <string>
#include <unordered_map>
#include <utility>

/// Checks a property so many times, always from the same seed. A failure shows the smallest
/// counterexample that was found, and the seed. `max_size` bounds the lengths of containers.
template <class Property>
void expect_property(std::uint64_t seed, int runs, int max_size, Property&& property) {
    rc::detail::TestParams parameters;
    parameters.seed = seed;
    parameters.maxSuccess = runs;
    parameters.maxSize = max_size;
    const std::unordered_map<std::string, rc::detail::Reproduce> no_reproductions;
    rc::detail::TestListenerAdapter listener;  // one of our own, so that no other seed is announced
    const rc::detail::TestResult result =
        rc::detail::checkTestable(std::forward<Property>(property), rc::detail::TestMetadata{},
                                  parameters, listener, no_reproductions);
    if (result.template is<rc::detail::SuccessResult>()) return;
    std::ostringstream message;
    rc::detail::printResultMessage(result, message);
    ADD_FAILURE() << "seed " << seed << "\n" << message.str();
}
