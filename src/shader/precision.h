// SPDX-License-Identifier: MIT
// In which numbers a program calculates.
#pragma once

#include <string_view>

namespace shader {

enum class Precision {
    single,     ///< single precision, in world coordinates
    recentred,  ///< single precision, in coordinates about an origin that is chosen in double
    doubled,    ///< double precision
};

/// As users see it: single, recentred, double.
constexpr std::string_view name_of(Precision precision) {
    switch (precision) {
        case Precision::single:
            return "single";
        case Precision::recentred:
            return "recentred";
        case Precision::doubled:
            return "double";
    }
    return "";
}

}  // namespace shader
