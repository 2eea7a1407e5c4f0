// SPDX-License-Identifier: MIT
// What is wrong with a text that is not JSON, in plain words.
#pragma once

#include <cstddef>
#include <string_view>

#include "base/diagnostic.h"

namespace scene {

/// Where a reader of JSON stood when it could not go on.
struct JsonStop {
    enum class After { nothing, opening, key, value, everything };
    After after = After::nothing;  ///< what came last: a bracket opened, a key, or a value
    bool in_object = false;        ///< else in a list, or outside of everything
    std::size_t last_end = 0;      ///< where that ended
    std::size_t consumed = 0;      ///< bytes looked at
    bool ran_out = false;          ///< it wanted more than there is
};

base::Diagnostic explain_json_stop(std::string_view text, const JsonStop& stop);

}  // namespace scene
