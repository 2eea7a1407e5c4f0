// SPDX-License-Identifier: MIT
// PNG files through libpng's simplified interface, which reports errors without jumping.
#include "image/png.h"

#include <png.h>

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/file.h"

namespace image {
namespace {

constexpr std::size_t largest_file = std::size_t{1} << 31;
constexpr std::size_t most_pixels = std::size_t{1} << 28;

/// libpng's own state, freed at the end of its life.
struct Control {
    png_image image{};

    Control() { image.version = PNG_IMAGE_VERSION; }
    ~Control() { png_image_free(&image); }
    Control(const Control&) = delete;
    Control& operator=(const Control&) = delete;
};

base::Diagnostic problem(std::string_view verb, const std::filesystem::path& path,
                         std::string_view why) {
    return base::error(fmt::format("cannot {} '{}': {}", verb, path.string(), why));
}

}  // namespace

base::Result<std::string> encode_png(const Picture& picture) {
    if (picture.values.empty()) return base::error("the picture has no pixels");
    Control control;
    control.image.width = static_cast<png_uint_32>(picture.width);
    control.image.height = static_cast<png_uint_32>(picture.height);
    control.image.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(control.image);
    std::string bytes(size, '\0');
    if (!png_image_write_to_memory(&control.image, bytes.data(), &size, 0, picture.values.data(), 0,
                                   nullptr)) {
        return base::error(control.image.message);
    }
    bytes.resize(size);
    return bytes;
}

base::Status write_png(const std::filesystem::path& path, const Picture& picture) {
    const base::Result<std::string> bytes = encode_png(picture);
    if (!bytes) return problem("write", path, bytes.problems()[0].message);
    return base::write_atomically(path, *bytes);
}

base::Result<Picture> read_png(const std::filesystem::path& path) {
    const base::Result<std::string> file = base::read_text(path, largest_file);
    if (!file) return file.problems();
    Control control;
    if (!png_image_begin_read_from_memory(&control.image, file->data(), file->size())) {
        return problem("read", path,
                       fmt::format("it is not a PNG file ({})", control.image.message));
    }
    const std::size_t pixels = std::size_t{control.image.width} * control.image.height;
    if (pixels > most_pixels) return problem("read", path, "the picture is too large");
    // With alpha, which is then dropped: asked for RGB, libpng would mix in a background.
    control.image.format = PNG_FORMAT_RGBA;
    std::vector<std::uint8_t> values(PNG_IMAGE_SIZE(control.image));
    if (!png_image_finish_read(&control.image, nullptr, values.data(), 0, nullptr)) {
        return problem("read", path,
                       fmt::format("the PNG file is damaged ({})", control.image.message));
    }
    Picture picture(static_cast<int>(control.image.width), static_cast<int>(control.image.height));
    for (std::size_t i = 0; i < pixels; ++i) {
        for (std::size_t k = 0; k < 3; ++k) picture.values[3 * i + k] = values[4 * i + k];
    }
    return picture;
}

}  // namespace image
