// SPDX-License-Identifier: MIT
// References as files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.h"
#include "oracle/reference.h"

namespace oracle {

/// The bytes of a file: a line that names the format, its version and the size, then numbers,
/// little-endian, and a checksum. Same reference, same bytes.
std::string to_bytes(const Reference& reference);
/// Error: a text that is no reference, of another version, cut off or damaged.
base::Result<Reference> from_bytes(std::string_view bytes);

/// The file is there either whole or as it was before.
base::Status write_reference(const std::filesystem::path& path, const Reference& reference);
base::Result<Reference> read_reference(const std::filesystem::path& path);

}  // namespace oracle
