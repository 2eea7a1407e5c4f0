// SPDX-License-Identifier: MIT
// A driver's messages about a shader, made readable.
#pragma once

#include <string>
#include <string_view>

namespace render {

/// The log with the source line that each message speaks of underneath. Understands the forms
/// "0:12(5): error" (Mesa), "0(12) : error" (NVIDIA) and "ERROR: 0:12:" (AMD, Intel); other lines
/// are kept as they are. At most `most_lines` lines of the log are kept.
std::string annotate(std::string_view log, std::string_view source, int most_lines = 12);

}  // namespace render
