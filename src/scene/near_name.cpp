// SPDX-License-Identifier: MIT
#include "scene/near_name.h"

#include <algorithm>

#include "base/edit_distance.h"

namespace scene {

std::string near_name(std::string_view name, const std::vector<std::string>& candidates) {
    std::string best;
    std::size_t least = std::max<std::size_t>(1, name.size() / 3) + 1;
    for (const std::string& candidate : candidates) {
        const std::size_t apart = base::edit_distance(name, candidate);
        if (apart < least && apart < candidate.size()) {
            least = apart;
            best = candidate;
        }
    }
    return best;
}

}  // namespace scene
