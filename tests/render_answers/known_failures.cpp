// SPDX-License-Identifier: MIT
#include "render_answers/known_failures.h"

#include <array>

namespace render_answers {
namespace {

struct KnownFailure {
    std::string_view name;
    int wrong_pixels;
};

constexpr std::array<KnownFailure, 0> known_failures{};

}  // namespace

int known_wrong_pixels(std::string_view name) {
    for (const KnownFailure& failure : known_failures) {
        if (failure.name == name) return failure.wrong_pixels;
    }
    return 0;
}

}  // namespace render_answers
