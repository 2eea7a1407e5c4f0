// SPDX-License-Identifier: MIT
// Draws a view part by part. A part is one filling of the canvas, drawn in bands of rows.
#include "render/still.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <new>
#include <utility>

#include <fmt/format.h>

namespace render {

namespace {

using Clock = std::chrono::steady_clock;

/// The largest side of the canvas; larger pictures fill it several times.
constexpr int canvas_side = 2048;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// How many rows are drawn between two waits: few enough that no driver's watchdog takes a slow
/// scene for a hang, many enough that a fast one is not held up. Does not change the pixels.
class BandHeight {
public:
    int rows() const { return rows_; }

    void adapt(double seconds) {
        if (seconds < 0.05) rows_ = std::min(rows_ * 2, canvas_side);
        if (seconds > 0.2) rows_ = std::max(rows_ / 2, 8);
    }

private:
    int rows_ = 64;
};

base::Status check_view(const View& view) {
    if (view.width <= 0 || view.height <= 0)
        return base::error(
            fmt::format("a picture of {}x{} pixels is empty; both sides must be at least 1",
                        view.width, view.height));
    if (view.width > largest_side || view.height > largest_side)
        return base::error(
            fmt::format("a picture of {}x{} pixels is too large; neither side may be above {}",
                        view.width, view.height, largest_side));
    if (view.region_width <= 0 || view.region_height <= 0)
        return base::error(
            fmt::format("a region of {}x{} pixels is empty; both sides must be at least 1",
                        view.region_width, view.region_height));
    const long long right = static_cast<long long>(view.x) + view.region_width;
    const long long bottom = static_cast<long long>(view.y) + view.region_height;
    if (view.x < 0 || view.y < 0 || right > view.width || bottom > view.height)
        return base::error(fmt::format(
            "the region {},{},{},{} (left, top, width, height) reaches out of the "
            "picture of {}x{} pixels",
            view.x, view.y, view.region_width, view.region_height, view.width, view.height));
    const long long pixels = static_cast<long long>(view.region_width) * view.region_height;
    if (pixels > most_pixels)
        return base::error(fmt::format(
            "{}x{} are {} pixels, but at most {} are drawn at once; draw the picture in regions",
            view.region_width, view.region_height, pixels, most_pixels));
    return base::Done{};
}

/// The region cut into pieces that the canvas holds, in pixels from the region's left and top.
std::vector<Tile> parts(const View& view, const Canvas& canvas) {
    std::vector<Tile> list;
    for (int y = 0; y < view.region_height; y += canvas.height())
        for (int x = 0; x < view.region_width; x += canvas.width())
            list.push_back({x, y, std::min(canvas.width(), view.region_width - x),
                            std::min(canvas.height(), view.region_height - y)});
    return list;
}

View view_of(const View& view, const Tile& part) {
    return {view.width, view.height, view.x + part.x, view.y + part.y, part.width, part.height};
}

/// Draws a part and waits for it; the seconds that it took.
double draw_part(Canvas& canvas, const Program& program, const Frame& frame,
                 const shader::FieldNumbers& numbers, const Tile& part, BandHeight& band) {
    const Clock::time_point start = Clock::now();
    for (int y = 0; y < part.height;) {
        const Clock::time_point band_start = Clock::now();
        const int rows = std::min(band.rows(), part.height - y);
        canvas.draw(program, frame, numbers, {0, y, part.width, rows});
        canvas.finish();
        band.adapt(seconds_since(band_start));
        y += rows;
    }
    return seconds_since(start);
}

template <class Value, int Channels>
void paste(image::Image<Value, Channels>& whole, const image::Image<Value, Channels>& piece,
           const Tile& part) {
    if (piece.values.empty()) return;
    for (int y = 0; y < part.height; ++y)
        std::copy_n(piece.at(0, y), static_cast<std::size_t>(part.width) * Channels,
                    whole.at(part.x, part.y + y));
}

void read_part(Still& still, const Canvas& canvas, const Tile& part) {
    paste(still.picture, canvas.read_picture(), part);
    paste(still.geometry, canvas.read_geometry(), part);
    paste(still.normal, canvas.read_normal(), part);
}

Still empty_still(const View& view, const shader::Outputs& outputs) {
    Still still;
    const int width = view.region_width;
    const int height = view.region_height;
    if (outputs.picture) still.picture = image::Picture(width, height);
    if (outputs.geometry) still.geometry = image::Image<float, 4>(width, height);
    if (outputs.normal) still.normal = image::Image<float, 4>(width, height);
    return still;
}

base::Result<Still> draw(Context& context, const shader::ProgramSource& source,
                         const shader::FieldNumbers& numbers,
                         const std::function<Frame(const View&)>& frame_of, const View& view,
                         const shader::Outputs& outputs, int repeat) {
    const Gl& gl = context.gl();
    const int side = std::min(canvas_side, context.largest_size());
    auto canvas = Canvas::create(gl, std::min(view.region_width, side),
                                 std::min(view.region_height, side), outputs);
    if (!canvas) return canvas.problems();
    Still still = empty_still(view, outputs);

    const Clock::time_point link_start = Clock::now();
    const auto program = Program::link(gl, source);
    if (!program) return program.problems();
    still.link_seconds = seconds_since(link_start);

    BandHeight band;
    const std::vector<Tile> pieces = parts(view, *canvas);
    for (const Tile& part : pieces) {
        still.first_frame_seconds +=
            draw_part(*canvas, *program, frame_of(view_of(view, part)), numbers, part, band);
        read_part(still, *canvas, part);
    }
    for (int i = 0; i < repeat; ++i) {
        double seconds = 0;
        for (const Tile& part : pieces)
            seconds +=
                draw_part(*canvas, *program, frame_of(view_of(view, part)), numbers, part, band);
        still.frame_seconds.push_back(seconds);
    }
    if (const GLenum problem = gl.GetError(); problem != GL_NO_ERROR)
        return base::error(fmt::format(
            "the driver failed while drawing (OpenGL error {:#06x}); draw a smaller picture or "
            "fewer steps",
            problem));
    return still;
}

}  // namespace

base::Result<Still> draw_still(Context& context, const shader::ProgramSource& source,
                               const shader::FieldNumbers& numbers,
                               const std::function<Frame(const View&)>& frame_of, const View& view,
                               const shader::Outputs& outputs, int repeat) {
    assert(numbers.values.size() == source.field_values.size());
    if (auto fits = check_view(view); !fits) return fits.problems();
    try {
        return draw(context, source, numbers, frame_of, view, outputs, repeat);
    } catch (const std::bad_alloc&) {
        return base::error(
            fmt::format("there is not enough memory for {}x{} pixels; draw the picture in regions",
                        view.region_width, view.region_height));
    }
}

}  // namespace render
