// SPDX-License-Identifier: MIT
// PFM files: a short text header, then floats, the bottom row first.
#include "image/pfm.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/file.h"

namespace image {
namespace {

constexpr std::size_t largest_file = std::size_t{1} << 32;
constexpr int largest_side = 1 << 16;

std::uint32_t swap_bytes(std::uint32_t bits) {
    return bits >> 24 | (bits >> 8 & 0xFF00) | (bits << 8 & 0xFF0000) | bits << 24;
}

/// One float's four bytes in a given order of the file.
void copy_float(char* to, const char* from, bool swapped) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, from, sizeof bits);
    if (swapped) bits = swap_bytes(bits);
    std::memcpy(to, &bits, sizeof bits);
}

constexpr bool little_endian_host = std::endian::native == std::endian::little;

template <class Floats>
base::Status write(const std::filesystem::path& path, const Floats& image) {
    std::string bytes = fmt::format("{}\n{} {}\n-1.0\n", Floats::channels == 1 ? "Pf" : "PF",
                                    image.width, image.height);
    const std::size_t header = bytes.size();
    const std::size_t row = static_cast<std::size_t>(image.width) * Floats::channels;
    bytes.resize(header + image.values.size() * sizeof(float));
    char* to = bytes.data() + header;
    for (int y = image.height; y-- > 0;) {
        const float* from = image.values.data() + static_cast<std::size_t>(y) * row;
        for (std::size_t i = 0; i < row; ++i, to += sizeof(float)) {
            copy_float(to, reinterpret_cast<const char*>(from + i), !little_endian_host);
        }
    }
    return base::write_atomically(path, bytes);
}

struct Header {
    int channels = 0;
    int width = 0;
    int height = 0;
    bool little_endian = true;
    std::size_t size = 0;  ///< bytes up to the first float
};

bool is_space(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

/// The next word, and exactly one white space after it.
std::string_view next_word(std::string_view bytes, std::size_t& at) {
    while (at < bytes.size() && is_space(bytes[at])) ++at;
    const std::size_t begin = at;
    while (at < bytes.size() && at - begin < 32 && !is_space(bytes[at])) ++at;
    const std::string_view word = bytes.substr(begin, at - begin);
    if (at < bytes.size()) ++at;
    return word;
}

template <class Number>
bool parse_number(std::string_view word, Number& number) {
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), number);
    return failure == std::errc() && end == word.data() + word.size();
}

std::optional<Header> parse_header(std::string_view bytes) {
    Header header;
    const std::string_view kind = next_word(bytes, header.size);
    header.channels = kind == "Pf" ? 1 : kind == "PF" ? 3 : 0;
    double scale = 0;
    const bool fine = header.channels != 0 &&
                      parse_number(next_word(bytes, header.size), header.width) &&
                      parse_number(next_word(bytes, header.size), header.height) &&
                      parse_number(next_word(bytes, header.size), scale) && scale != 0 &&
                      std::isfinite(scale) && header.width > 0 && header.height > 0 &&
                      header.width <= largest_side && header.height <= largest_side;
    header.little_endian = scale < 0;
    return fine ? std::optional(header) : std::nullopt;
}

base::Diagnostic cannot_read(const std::filesystem::path& path, std::string_view why) {
    return base::error(fmt::format("cannot read '{}': {}", path.string(), why));
}

template <class Floats>
base::Result<Floats> read(const std::filesystem::path& path) {
    const base::Result<std::string> file = base::read_text(path, largest_file);
    if (!file) return file.problems();
    const std::string& bytes = *file;
    const std::optional<Header> header = parse_header(bytes);
    if (!header) return cannot_read(path, "it is not a PFM file");
    if (header->channels != Floats::channels) {
        return cannot_read(path, Floats::channels == 1 ? "it is a colour PFM, not a grey one"
                                                       : "it is a grey PFM, not a colour one");
    }
    const std::size_t count =
        static_cast<std::size_t>(header->width) * header->height * Floats::channels;
    if (bytes.size() - header->size < count * sizeof(float)) {
        return cannot_read(path, "it ends in the middle of the picture; it may have been cut off");
    }
    Floats image(header->width, header->height);
    const std::size_t row = static_cast<std::size_t>(header->width) * Floats::channels;
    const char* from = bytes.data() + header->size;
    for (int y = header->height; y-- > 0;) {
        float* to = image.values.data() + static_cast<std::size_t>(y) * row;
        for (std::size_t i = 0; i < row; ++i, from += sizeof(float)) {
            copy_float(reinterpret_cast<char*>(to + i), from,
                       header->little_endian != little_endian_host);
        }
    }
    return image;
}

}  // namespace

base::Status write_pfm(const std::filesystem::path& path, const Grey& image) {
    return write(path, image);
}

base::Status write_pfm(const std::filesystem::path& path, const Vectors& image) {
    return write(path, image);
}

base::Result<Grey> read_pfm_grey(const std::filesystem::path& path) { return read<Grey>(path); }

base::Result<Vectors> read_pfm_vectors(const std::filesystem::path& path) {
    return read<Vectors>(path);
}

}  // namespace image
