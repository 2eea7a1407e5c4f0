// SPDX-License-Identifier: MIT
#include "oracle/reference_file.h"

#include <bit>
#include <cstdio>

#include <fmt/format.h>

#include "base/file.h"
#include "oracle/hash.h"

namespace oracle {
namespace {

constexpr std::string_view title = "zeroset reference 2";
constexpr std::size_t bytes_a_pixel = 1 + 1 + 4 + 5 * 8;
constexpr std::size_t checksum_size = 8;
constexpr std::size_t longest_header = 200;
constexpr int largest_side = 32768;
constexpr std::size_t largest_file = std::size_t{4} << 30;

void put(std::string& bytes, std::uint64_t value, int count) {
    for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> 8 * i & 0xff);
}
void put(std::string& bytes, double value) { put(bytes, std::bit_cast<std::uint64_t>(value), 8); }

/// Takes numbers off the front of bytes that are long enough.
class Taker {
public:
    explicit Taker(std::string_view bytes) : bytes_(bytes) {}

    std::uint64_t whole(int count) {
        std::uint64_t value = 0;
        for (int i = 0; i < count; ++i) {
            value |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes_[at_++])) << 8 * i;
        }
        return value;
    }
    double real() { return std::bit_cast<double>(whole(8)); }

private:
    std::string_view bytes_;
    std::size_t at_ = 0;
};

void put(std::string& bytes, const Pixel& pixel) {
    put(bytes, static_cast<std::uint64_t>(pixel.verdict), 1);
    put(bytes, (pixel.fragile ? 1 : 0) + (pixel.estimated ? 2 : 0), 1);
    put(bytes, static_cast<std::uint32_t>(pixel.object), 4);
    for (const double number :
         {pixel.near, pixel.far, pixel.normal.x, pixel.normal.y, pixel.normal.z}) {
        put(bytes, number);
    }
}

bool take(Taker& from, Pixel& pixel) {
    const std::uint64_t verdict = from.whole(1);
    if (verdict > static_cast<std::uint64_t>(Verdict::undecided)) return false;
    pixel.verdict = static_cast<Verdict>(verdict);
    const std::uint64_t flags = from.whole(1);
    pixel.fragile = (flags & 1) != 0;
    pixel.estimated = (flags & 2) != 0;
    pixel.object = static_cast<std::int32_t>(static_cast<std::uint32_t>(from.whole(4)));
    pixel.near = from.real();
    pixel.far = from.real();
    for (int i = 0; i < 3; ++i) pixel.normal[i] = from.real();
    return true;
}

base::Diagnostic damaged() {
    return base::error("the reference is cut off or damaged; make it again with 'zeroset oracle'");
}

}  // namespace

std::string to_bytes(const Reference& reference) {
    std::string bytes = fmt::format("{} {} {}\n", title, reference.width, reference.height);
    bytes.reserve(bytes.size() + bytes_a_pixel * reference.pixels.size() + 32);
    put(bytes, reference.pixel_width);
    put(bytes, reference.heuristic ? 1 : 0, 1);
    for (const Pixel& pixel : reference.pixels) put(bytes, pixel);
    put(bytes, hash(bytes), checksum_size);
    return bytes;
}

base::Result<Reference> from_bytes(std::string_view bytes) {
    const std::size_t line = bytes.substr(0, longest_header).find('\n');
    Reference reference;
    int length = 0;
    const std::string header(bytes.substr(0, line == std::string_view::npos ? 0 : line));
    if (!header.starts_with(title) ||
        std::sscanf(header.c_str() + title.size(), " %d %d%n", &reference.width, &reference.height,
                    &length) != 2) {
        return base::error(
            "this is no reference of this version; make one with 'zeroset oracle --reference'");
    }
    const bool sensible = reference.width >= 1 && reference.height >= 1 &&
                          std::max(reference.width, reference.height) <= largest_side;
    const std::size_t pixels =
        sensible ? static_cast<std::size_t>(reference.width) * reference.height : 0;
    const std::size_t size = line + 1 + 9 + pixels * bytes_a_pixel + checksum_size;
    if (!sensible || bytes.size() != size) return damaged();
    const std::string_view body = bytes.substr(0, size - checksum_size);
    if (Taker(bytes.substr(body.size())).whole(8) != hash(body)) return damaged();
    Taker from(body.substr(line + 1));
    reference.pixel_width = from.real();
    reference.heuristic = from.whole(1) != 0;
    reference.pixels.resize(pixels);
    for (Pixel& pixel : reference.pixels) {
        if (!take(from, pixel)) return damaged();
    }
    return reference;
}

base::Status write_reference(const std::filesystem::path& path, const Reference& reference) {
    return base::write_atomically(path, to_bytes(reference));
}

base::Result<Reference> read_reference(const std::filesystem::path& path) {
    const auto bytes = base::read_text(path, largest_file);
    if (!bytes) return bytes.problems();
    auto reference = from_bytes(*bytes);
    if (reference) return reference;
    base::Diagnostic problem = reference.problems().front();
    problem.message = fmt::format("cannot read '{}': {}", path.string(), problem.message);
    return problem;
}

}  // namespace oracle
