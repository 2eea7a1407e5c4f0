// SPDX-License-Identifier: MIT
#include "formula/suggest.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

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
    {"length", "hypot"},
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

std::size_t edit_distance(std::string_view a, std::string_view b) {
    // Three rows of the table of distances between the beginnings of a and b.
    std::vector<std::size_t> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) above[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                row[j] = std::min(row[j], before[j - 2] + 1);
            }
        }
        std::swap(before, above);
        std::swap(above, row);
    }
    return above[b.size()];
}

std::string_view nearest(std::string_view name, std::span<const std::string_view> candidates) {
    const std::string lower = lower_case(name);
    std::string_view best;
    std::size_t best_distance = tolerance(name) + 1;
    for (const std::string_view candidate : candidates) {
        const std::size_t longer = std::max(candidate.size(), name.size());
        if (longer - std::min(candidate.size(), name.size()) > 2) continue;
        const std::string other = lower_case(candidate);
        const std::size_t distance = lower == other ? 0 : edit_distance(lower, other);
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
