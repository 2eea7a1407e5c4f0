// SPDX-License-Identifier: MIT
// Decides which part of the live picture is drawn next: a coarse picture at once, the full one when
// nothing moves any more, in tiles whose size follows from what drawing has cost so far. Knows
// neither OpenGL nor the user interface.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>

#include "render/passes.h"
#include "render/tile_parts.h"

namespace studio {

/// A piece of drawing: one tile of a picture that is 1/divisor of the full size.
struct DrawingStep {
    int divisor = 1;
    int width = 0, height = 0;  ///< of the whole picture that the tile is a part of
    render::Tile tile;
    /// The first pass to run: those before have been run for the whole full picture already.
    render::Pass pass = render::Pass::geometry;
    bool first = false;  ///< the first tile of its picture
    bool last = false;   ///< the last tile of its picture

    bool full() const { return divisor == 1; }
};

/// The order of drawing. Times are seconds of a clock that never goes back. A coarse picture that
/// has been begun is finished even if the scene changes meanwhile, so that there is always
/// something new to see; a full one is given up at once.
class PictureScheduler {
public:
    /// One tile should take about this long, and never so long that a driver's watchdog fires.
    static constexpr double tile_seconds = 0.008;
    /// A coarse picture may take about this long.
    static constexpr double coarse_seconds = 0.030;
    /// A full picture is drawn at once, without a coarse one before it, if it takes at most this.
    static constexpr double immediate_seconds = 0.018;
    /// The scene rests when it has not changed for this long.
    static constexpr double rest_seconds = 0.15;

    /// The size of the full picture; a change of it is a change of the scene.
    void resize(int width, int height, double now);
    /// What this pass reads has changed, and nothing that one before it reads.
    void change(double now, render::Pass first = render::Pass::geometry);
    /// The program has changed: its cost is unknown, and what was begun with the old one is void.
    void restart(double now);

    /// The next tile to draw, if there is something to do at this time. The same tile is answered
    /// until `done` is called for it.
    std::optional<DrawingStep> next(double now);
    /// The tile has been drawn and took so long.
    void done(const DrawingStep& step, double seconds);

    /// Seconds until `next` has something: 0 for now, infinity for never.
    double wait(double now) const;
    /// True if the full picture of the present scene is complete.
    bool complete() const { return full_version_ == version_; }
    /// True if the scene has not changed for a while.
    bool resting(double now) const { return now - changed_ >= rest_seconds; }
    /// Drawing time of the last full picture that was drawn by all passes.
    double full_seconds() const { return full_seconds_; }

private:
    /// A picture that is being drawn.
    struct Sweep {
        std::uint64_t version = 0;
        render::Pass pass = render::Pass::geometry;
        int divisor = 1;
        int width = 0, height = 0;
        std::deque<render::Tile> tiles;
        bool begun = false;
        double seconds = 0;
    };

    /// What drawing a pixel from some pass on has cost in the last picture.
    struct Cost {
        double pixel_seconds = 1e-6;
        bool known = false;
    };

    const Cost& cost() const { return costs_[static_cast<std::size_t>(pass_)]; }
    int chosen_divisor() const;
    Sweep new_sweep(int divisor) const;
    void split_costly_front();

    int width_ = 0, height_ = 0;
    double changed_ = -std::numeric_limits<double>::infinity();
    std::uint64_t version_ = 0, coarse_version_ = 0, full_version_ = 0;
    std::optional<Sweep> sweep_;
    render::Pass pass_ = render::Pass::geometry;  ///< the first that the full picture lacks
    std::array<Cost, 3> costs_;                   ///< by the first pass
    double last_pixel_seconds_ = 1e-6;            ///< of the last tile
    double full_seconds_ = 0;
};

}  // namespace studio
