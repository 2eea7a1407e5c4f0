// SPDX-License-Identifier: MIT
#include "formula/suggest.h"

#include "base/edit_distance.h"

#include <algorithm>
#include <string>
#include <utility>

namespace formula {
namespace {

constexpr std::pair<std::string_view, std::string_view> synonyms[] = {
    {"ln", "log"},
    {"arcsin", "asin"},
    {"arccos", "acos"},
    {"arctan", "atan"},
    {"arctan2", "atan2"},
    {"fabs", "abs"},
    {"fmod", "mod"},
    {"power", "pow"},
    {"norm", "length"},
    {"magnitude", "length"},
    {"quat", "quaternion"},
    {"conjugate", "conj"},
    {"select", "if"},
    {"sgn", "sign"},
    {"lerp", "mix"},
    {"sgrt", "sqrt"},
    {"subtract", "difference"},
    {"intersect", "intersection"},
    {"cube", "box"},
    {"ball", "sphere"},
};

std::string lower_case(std::string_view name) {
    std::string text(name);
    for (char& c : text) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return text;
}

std::size_t tolerance(std::string_view name) {
    if (name.size() < 3) return 0;
    return name.size() < 6 ? 1 : 2;
}

}  // namespace

std::string_view nearest(std::string_view name, std::span<const std::string_view> candidates) {
    const std::string lower = lower_case(name);
    std::string_view best;
    std::size_t best_distance = tolerance(name) + 1;
    for (const std::string_view candidate : candidates) {
        const std::size_t longer = std::max(candidate.size(), name.size());
        if (longer - std::min(candidate.size(), name.size()) > 2) continue;
        const std::string other = lower_case(candidate);
        const std::size_t distance = lower == other ? 0 : base::edit_distance(lower, other);
        if (distance < best_distance || (distance == best_distance && candidate < best)) {
            best = candidate;
            best_distance = distance;
        }
    }
    if (best_distance == 0) return best;
    for (const auto& [elsewhere, here] : synonyms) {
        const bool known = std::ranges::find(candidates, here) != candidates.end();
        if (elsewhere == lower && known) return here;
    }
    return best;
}

}  // namespace formula
