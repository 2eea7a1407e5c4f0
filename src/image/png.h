// SPDX-License-Identifier: MIT
// PNG files.
#pragma once

#include <filesystem>
#include <string>

#include "base/result.h"
#include "image/image.h"

namespace image {

/// The bytes of a PNG file: 8-bit sRGB. Error: no pixels.
base::Result<std::string> encode_png(const Picture& picture);

/// Writes 8-bit sRGB. The file is there either whole or as it was before.
base::Status write_png(const std::filesystem::path& path, const Picture& picture);
/// Reads any PNG as 8-bit RGB; alpha is dropped.
base::Result<Picture> read_png(const std::filesystem::path& path);

}  // namespace image
