// SPDX-License-Identifier: MIT
// The steps from each version to the next.
#include "scene/preset_migrate.h"

#include <array>
#include <cassert>

namespace scene {
namespace {

/// Element i leads from version i + 1 to version i + 2. Version 1 is the first one, so there is no
/// step yet.
constexpr std::array<void (*)(Json&), preset_version - 1> steps{};

}  // namespace

Json migrate(Json preset, int version) {
    assert(version >= 1 && version <= preset_version);
    for (auto i = static_cast<std::size_t>(version - 1); i < steps.size(); ++i) steps[i](preset);
    return preset;
}

}  // namespace scene
