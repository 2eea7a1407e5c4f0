// SPDX-License-Identifier: MIT
// A number for bytes that differs where they differ, as good as always.
#pragma once

#include <cstdint>
#include <string_view>

namespace oracle {

/// FNV-1a with 64 bits (Fowler, Noll, Vo). Against accidents, not against malice.
constexpr std::uint64_t hash(std::string_view bytes, std::uint64_t start = 0xcbf29ce484222325U) {
    std::uint64_t value = start;
    for (const char byte : bytes) {
        value = (value ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
    }
    return value;
}

}  // namespace oracle
