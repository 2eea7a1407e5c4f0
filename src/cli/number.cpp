// SPDX-License-Identifier: MIT
#include "cli/number.h"

#include <charconv>
#include <cmath>

namespace cli {

std::optional<double> finite_number(std::string_view text) {
    double value = 0;
    const char* begin = text.starts_with('+') ? text.data() + 1 : text.data();
    const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
        return std::nullopt;
    }
    return value;
}

}  // namespace cli
