// SPDX-License-Identifier: MIT
// The size of a picture as it is typed on a command line.
#pragma once

#include <string_view>

namespace cli {

struct Size {
    int width = 0;
    int height = 0;
};

/// Understands 1280x720; throws CLI::ValidationError in the option's name.
Size parse_size(std::string_view text, std::string_view option);

/// Throws CLI::ValidationError in the option's name.
int whole_number(std::string_view text, std::string_view option);

}  // namespace cli
