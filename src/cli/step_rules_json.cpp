// SPDX-License-Identifier: MIT
#include "cli/step_rules_json.h"

#include <cmath>

#include <nlohmann/json.hpp>

namespace cli {
namespace {

nlohmann::ordered_json number(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

}  // namespace

nlohmann::ordered_json step_rules_json(std::span<const compile::StepRule> rules) {
    auto list = nlohmann::ordered_json::array();
    for (const compile::StepRule& rule : rules) {
        list.push_back({{"object", rule.first_object},
                        {"objects", rule.objects},
                        {"certified", rule.proven()},
                        {"by", describe(rule)},
                        {"lipschitz", number(rule.lipschitz)},
                        {"second_derivative", number(rule.second_derivative)}});
    }
    return list;
}

}  // namespace cli
