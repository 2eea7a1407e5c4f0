// SPDX-License-Identifier: MIT
#include "oracle/cache.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "oracle/hash.h"
#include "oracle/reference_file.h"
#include "scene/preset.h"

namespace oracle {
namespace {

namespace fs = std::filesystem;

/// To be raised with every change of what a reference is, or of how it is found.
constexpr int method_version = 4;

constexpr std::string_view extension = ".reference";

/// All that a reference depends on, as text: what does not is left out of the document.
std::string key_of(const scene::Document& document, const Query& query) {
    scene::Document bare;
    bare.formula = document.formula;
    bare.parameters = document.parameters;
    bare.time = document.time;
    bare.bounds = document.bounds;
    bare.camera = scene::camera_of(document, static_cast<double>(query.width) / query.height);
    std::string key = fmt::format("method {}\n{}x{}\n", method_version, query.width, query.height);
    if (query.region) {
        for (const int number : *query.region) key += fmt::format("{} ", number);
    }
    return key + scene::write_preset(bare);
}

/// Two hashes with different starts: 128 bits.
std::string file_name(std::string_view key) {
    const std::uint64_t first = hash(key);
    return fmt::format("{:016x}{:016x}{}", first, hash(key, first ^ 0x9e3779b97f4a7c15U),
                       extension);
}

}  // namespace

fs::path cache_folder() {
    const auto variable = [](const char* name) -> std::string {
        const char* value = std::getenv(name);
        return value ? value : "";
    };
    // Relative paths there are to be ignored, says the XDG specification.
    if (const fs::path cache = variable("XDG_CACHE_HOME"); cache.is_absolute()) {
        return cache / "zeroset" / "oracle";
    }
    if (const fs::path home = variable("HOME"); home.is_absolute()) {
        return home / ".cache" / "zeroset" / "oracle";
    }
    return {};
}

Cache::Cache(fs::path folder, std::uintmax_t bytes) : folder_(std::move(folder)), bytes_(bytes) {}

base::Result<Reference> Cache::get(std::string_view key,
                                   const std::function<base::Result<Reference>()>& make) const {
    if (folder_.empty()) return make();
    const fs::path file = folder_ / file_name(key);
    std::error_code error;
    if (fs::exists(file, error)) {
        if (auto known = read_reference(file)) {
            fs::last_write_time(file, fs::file_time_type::clock::now(), error);
            return known;
        }
    }
    auto made = make();
    if (!made) return made;
    fs::create_directories(folder_, error);
    if (error) return made;
    make_room(to_bytes(*made).size());
    (void)write_reference(file, *made);
    return made;
}

/// Removes the files that were not used for longest.
void Cache::make_room(std::uintmax_t needed) const {
    struct File {
        fs::path path;
        fs::file_time_type used;
        std::uintmax_t size;
    };
    std::vector<File> files;
    std::uintmax_t total = needed;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
        if (entry.path().extension() != extension) continue;
        const std::uintmax_t size = entry.file_size(error);
        const fs::file_time_type used = entry.last_write_time(error);
        if (error) continue;  // gone meanwhile
        files.push_back({entry.path(), used, size});
        total += size;
    }
    std::ranges::sort(files, {}, &File::used);
    for (const File& file : files) {
        if (total <= bytes_) return;
        if (fs::remove(file.path, error)) total -= file.size;
    }
}

base::Result<Reference> trace(const compile::Formula& formula, const scene::Document& document,
                              const Query& query, const Cache& cache) {
    return cache.get(key_of(document, query), [&] { return trace(formula, document, query); });
}

}  // namespace oracle
