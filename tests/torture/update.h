// SPDX-License-Identifier: MIT
// Whether a run of the suite rewrites its recorded numbers.
#pragma once

#include <cstdlib>
#include <string>

namespace torture {

enum class Update {
    none,
    shrink,  ///< UPDATE_TORTURE=1: what got better, and what is new
    raise,   ///< UPDATE_TORTURE=raise: everything as it is
};

inline Update update() {
    const char* value = std::getenv("UPDATE_TORTURE");
    const std::string text = value ? value : "";
    return text == "raise" ? Update::raise : text == "1" ? Update::shrink : Update::none;
}

}  // namespace torture
