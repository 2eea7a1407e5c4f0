// SPDX-License-Identifier: MIT
#include "oracle/trace.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "compile/parameter_values.h"
#include "oracle/fragile.h"

namespace oracle {
namespace {

constexpr int largest_side = 32768;

base::Status check(const Query& query) {
    if (std::min(query.width, query.height) < 1 ||
        std::max(query.width, query.height) > largest_side) {
        return base::error(fmt::format(
            "a reference of {}x{} pixels is out of range; width and height go from 1 to {}",
            query.width, query.height, largest_side));
    }
    if (!query.region) return base::Done{};
    const auto [x, y, width, height] = *query.region;
    if (x < 0 || y < 0 || width < 1 || height < 1 || width > query.width - x ||
        height > query.height - y) {
        return base::error(fmt::format(
            "the region {},{},{},{} is not inside of the picture of {}x{} pixels; choose a part of "
            "it",
            x, y, width, height, query.width, query.height));
    }
    return base::Done{};
}

/// Calls work(number, thread's own state) for numbers below a count, on several threads.
template <class MakeState, class Work>
void for_all(int count, int threads, const MakeState& make_state, const Work& work) {
    std::atomic<int> next{0};
    const auto run = [&] {
        auto state = make_state();
        for (int number = next++; number < count; number = next++) work(number, state);
    };
    std::vector<std::thread> others;
    for (int i = 1; i < std::min(threads, count); ++i) others.emplace_back(run);
    run();
    for (std::thread& other : others) other.join();
}

int thread_count(const Query& query) {
    if (query.threads > 0) return query.threads;
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Tiles are those of the full picture, so that a region is a crop of it bit for bit.
constexpr int large = 16, small = 4;

/// What both tiles have in common; without pixels if that is nothing.
Tile common(const Tile& a, const Tile& b) {
    Tile tile{std::max(a.x, b.x), std::max(a.y, b.y), 0, 0};
    tile.width = std::max(0, std::min(a.x + a.width, b.x + b.width) - tile.x);
    tile.height = std::max(0, std::min(a.y + a.height, b.y + b.height) - tile.y);
    return tile;
}

/// Calls visit(tile) for the tiles of this size that the area meets.
template <class Visit>
void for_tiles(const Tile& area, int size, const Visit& visit) {
    for (int y = area.y / size * size; y < area.y + area.height; y += size) {
        for (int x = area.x / size * size; x < area.x + area.width; x += size) {
            visit(Tile{x, y, size, size});
        }
    }
}

/// A picture on its way.
class Tracing {
public:
    Tracing(const compile::Formula& formula, const scene::Document& document, const Query& query,
            const Tile& area)
        : bounds_(document.bounds),
          pinhole_(scene::camera_of(document, static_cast<double>(query.width) / query.height),
                   query.width, query.height),
          shape_(make_shape(formula.field, compile::parameter_values(formula.field, document))),
          query_(query),
          area_(area) {
        reference_.width = area.width;
        reference_.height = area.height;
        reference_.pixel_width = pinhole_.pixel_width();
        reference_.pixels.resize(static_cast<std::size_t>(area.width) *
                                 static_cast<std::size_t>(area.height));
        for_tiles(area, large, [&](const Tile& tile) { tiles_.push_back(tile); });
        for (const Tile& tile : tiles_) {
            for_tiles(common(tile, area), small, [&](const Tile&) { ++parts_; });
        }
    }

    /// False if it was given up.
    bool run() {
        const auto trace_pixel = [&](PixelTracer& trace, int x, int y, const Places& places) {
            pixel(x, y) = trace(x + 0.5, y + 0.5, places);
        };
        const auto mark_pixel = [&](PixelTracer& trace, int x, int y, const Places& places) {
            Pixel& it = pixel(x, y);
            if (it.verdict == Verdict::undecided) return;
            if (!may_be_fragile(reference_, x - area_.x, y - area_.y)) return;
            it.fragile = is_fragile(trace, it, x + 0.5, y + 0.5, places, reference_.pixel_width);
        };
        return pass(0, 0.9, trace_pixel) && pass(0.9, 1, mark_pixel);
    }

    /// What of the area is asked for.
    Reference cropped(const Tile& to) const {
        Reference result = reference_;
        result.width = to.width;
        result.height = to.height;
        result.pixels.clear();
        for (int y = to.y; y < to.y + to.height; ++y) {
            for (int x = to.x; x < to.x + to.width; ++x) {
                result.pixels.push_back(reference_.at(x - area_.x, y - area_.y));
            }
        }
        result.heuristic = std::ranges::any_of(result.pixels, &Pixel::estimated);
        return result;
    }

private:
    /// Calls each(tracer, x, y, places) for all pixels; false if it was given up.
    template <class Each>
    bool pass(double from, double to, const Each& each) {
        finished_ = 0;
        const auto part = [&](PixelTracer& trace, const Tile& tile, const Places& around) {
            if (stopped_) return;
            const Places places = trace.places(tile, around);
            const Tile pixels = common(tile, area_);
            for (int y = pixels.y; y < pixels.y + pixels.height; ++y) {
                for (int x = pixels.x; x < pixels.x + pixels.width; ++x) each(trace, x, y, places);
            }
            const double fraction = static_cast<double>(++finished_) / parts_;
            if (query_.progress && !query_.progress(from + (to - from) * fraction)) stopped_ = true;
        };
        for_all(
            static_cast<int>(tiles_.size()), thread_count(query_),
            [&] { return PixelTracer(shape_, bounds_, pinhole_); },
            [&](int number, PixelTracer& trace) {
                if (stopped_) return;
                const Tile& tile = tiles_[static_cast<std::size_t>(number)];
                const Places around = trace.places(tile);
                for_tiles(common(tile, area_), small,
                          [&](const Tile& small_tile) { part(trace, small_tile, around); });
            });
        return !stopped_;
    }
    Pixel& pixel(int x, int y) {
        return reference_
            .pixels[static_cast<std::size_t>(y - area_.y) * static_cast<std::size_t>(area_.width) +
                    static_cast<std::size_t>(x - area_.x)];
    }

    const scene::Bounds bounds_;
    const Pinhole pinhole_;
    const Shape shape_;
    const Query& query_;
    const Tile area_;
    std::vector<Tile> tiles_;  ///< large ones
    int parts_ = 0;            ///< so many small ones
    std::atomic<int> finished_{0};
    std::atomic<bool> stopped_{false};
    Reference reference_;
};

}  // namespace

base::Result<Reference> trace(const compile::Formula& formula, const scene::Document& document,
                              const Query& query) {
    if (const base::Status status = check(query); !status) return status.problems();
    const Tile whole{0, 0, query.width, query.height};
    Tile wanted = whole;
    if (query.region) {
        const auto [x, y, width, height] = *query.region;
        wanted = {x, y, width, height};
    }
    // Whether a pixel is fragile is asked of its neighbours as well.
    const Tile area =
        common(whole, {wanted.x - 1, wanted.y - 1, wanted.width + 2, wanted.height + 2});
    Tracing tracing(formula, document, query, area);
    if (!tracing.run()) return base::error("the reference was given up; ask for it again");
    return tracing.cropped(wanted);
}

}  // namespace oracle
