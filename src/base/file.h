// SPDX-License-Identifier: MIT
// Whole files, in and out.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.h"

namespace base {

/// The whole content of a file. A missing file, a directory, a file without permission and one of
/// more than `max_bytes` are errors that name the path and say what to do. Pipes are read to their
/// end.
Result<std::string> read_text(const std::filesystem::path& path, std::size_t max_bytes);

/// Writes a file so that it is there either whole or as it was before: into a temporary file beside
/// it, which is flushed to the disk and renamed; on failure the temporary file is removed. A link
/// is followed, the mode of an existing file is kept. What is no regular file (a device, a pipe) is
/// written directly. An error says why: no such folder, a directory, no permission, a full disk.
Status write_atomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace base
