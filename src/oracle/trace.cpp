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

/// Calls work(row, thread's own state) for all rows, on several threads; false if it was stopped.
template <class MakeState, class Work>
bool for_rows(int rows, int threads, const MakeState& make_state,
              const std::function<bool(int)>& told, const Work& work) {
    std::atomic<int> next{0}, finished{0};
    std::atomic<bool> stopped{false};
    const auto run = [&] {
        auto state = make_state();
        while (!stopped) {
            const int row = next++;
            if (row >= rows) return;
            work(row, state);
            if (!told(++finished)) stopped = true;
        }
    };
    std::vector<std::thread> others;
    for (int i = 1; i < std::min(threads, rows); ++i) others.emplace_back(run);
    run();
    for (std::thread& other : others) other.join();
    return !stopped;
}

int thread_count(const Query& query) {
    if (query.threads > 0) return query.threads;
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace

base::Result<Reference> trace(const compile::Formula& formula, const scene::Document& document,
                              const Query& query) {
    if (const base::Status status = check(query); !status) return status.problems();
    const auto [left, top, width, height] =
        query.region.value_or(std::array<int, 4>{0, 0, query.width, query.height});
    const scene::Camera camera =
        scene::camera_of(document, static_cast<double>(query.width) / query.height);
    const Pinhole pinhole(camera, query.width, query.height);
    const Shape shape =
        make_shape(formula.field, compile::parameter_values(formula.field, document));

    Reference reference;
    reference.width = width;
    reference.height = height;
    reference.pixel_width = pinhole.pixel_width();
    reference.heuristic = !shape.loops.empty();
    reference.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const auto place = [&](int x, int y) -> Pixel& {
        return reference.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                static_cast<std::size_t>(x)];
    };
    const auto tracer = [&] { return PixelTracer(shape, document.bounds, pinhole); };
    const auto told = [&](double from, double to) {
        return [&query, from, to, rows = height](int finished) {
            return !query.progress || query.progress(from + (to - from) * finished / rows);
        };
    };
    const int threads = thread_count(query);
    bool done = for_rows(height, threads, tracer, told(0, 0.9), [&](int y, PixelTracer& trace) {
        for (int x = 0; x < width; ++x) place(x, y) = trace(left + x + 0.5, top + y + 0.5);
    });
    done = done && for_rows(height, threads, tracer, told(0.9, 1), [&](int y, PixelTracer& trace) {
               for (int x = 0; x < width; ++x) {
                   Pixel& pixel = place(x, y);
                   if (pixel.verdict == Verdict::undecided || !may_be_fragile(reference, x, y))
                       continue;
                   pixel.fragile = is_fragile(trace, pixel, left + x + 0.5, top + y + 0.5,
                                              pinhole.pixel_width());
               }
           });
    if (!done) return base::error("the reference was given up; ask for it again");
    return reference;
}

}  // namespace oracle
