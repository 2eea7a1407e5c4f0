// SPDX-License-Identifier: MIT
#include "cli/size.h"

#include <algorithm>
#include <charconv>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "render/still.h"

namespace cli {

int whole_number(std::string_view text, std::string_view option) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
        throw CLI::ValidationError(std::string(option),
                                   fmt::format("'{}' is not a whole number", text));
    }
    return value;
}

Size parse_size(std::string_view text, std::string_view option) {
    const std::size_t cross = text.find('x');
    if (cross == std::string_view::npos) {
        throw CLI::ValidationError(std::string(option),
                                   fmt::format("'{}' should be WxH, such as 1280x720", text));
    }
    const Size size{whole_number(text.substr(0, cross), option),
                    whole_number(text.substr(cross + 1), option)};
    if (std::min(size.width, size.height) < 1 ||
        std::max(size.width, size.height) > render::largest_side) {
        throw CLI::ValidationError(
            std::string(option), fmt::format("{} is out of range; width and height go from 1 to {}",
                                             text, render::largest_side));
    }
    return size;
}

}  // namespace cli
