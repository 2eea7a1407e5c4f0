// SPDX-License-Identifier: MIT
// References that were traced before, on the disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

#include "base/result.h"
#include "oracle/reference.h"
#include "oracle/trace.h"

namespace oracle {

/// $XDG_CACHE_HOME/zeroset/oracle, else the same under ~/.cache; empty if neither is known.
std::filesystem::path cache_folder();

/// A folder of references by the hash of what they are of. A file that is missing, damaged or
/// cannot be written is no error: then there is just no use of it.
class Cache {
public:
    /// All files together take at most so many bytes: the oldest ones are removed.
    static constexpr std::uintmax_t most_bytes = std::uintmax_t{1} << 30;

    /// An empty path keeps nothing.
    explicit Cache(std::filesystem::path folder, std::uintmax_t bytes = most_bytes);

    /// The reference of `key`, from the folder or else made and kept there.
    base::Result<Reference> get(std::string_view key,
                                const std::function<base::Result<Reference>()>& make) const;

private:
    void make_room(std::uintmax_t needed) const;

    std::filesystem::path folder_;
    std::uintmax_t bytes_;
};

/// As trace; what the document and the query say about the reference is looked for in the cache.
base::Result<Reference> trace(const compile::Formula& formula, const scene::Document& document,
                              const Query& query, const Cache& cache);

}  // namespace oracle
