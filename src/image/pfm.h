// SPDX-License-Identifier: MIT
// PFM files: 32-bit floats, little-endian (scale -1.0), rows from the bottom to the top.
#pragma once

#include <filesystem>

#include "base/result.h"
#include "image/image.h"

namespace image {

/// Writes a grey PFM ("Pf") or a colour PFM ("PF"). The file is there either whole or as it was
/// before.
base::Status write_pfm(const std::filesystem::path& path, const Grey& image);
base::Status write_pfm(const std::filesystem::path& path, const Vectors& image);
base::Result<Grey> read_pfm_grey(const std::filesystem::path& path);
base::Result<Vectors> read_pfm_vectors(const std::filesystem::path& path);

}  // namespace image
