// SPDX-License-Identifier: MIT
#include "studio/picture_scheduler.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace studio {
namespace {

constexpr int smallest_edge = 16;
constexpr int first_edge = 64;  // of a program whose cost is not known yet
constexpr int largest_edge = 1024;
constexpr std::array divisors = {1, 2, 3, 4, 6, 8};

double pixels(const render::Tile& tile) { return static_cast<double>(tile.width) * tile.height; }

/// The largest power of two whose square costs no more than one tile should.
int edge_for(double pixel_seconds) {
    int edge = smallest_edge;
    while (edge < largest_edge &&
           4.0 * edge * edge * pixel_seconds <= PictureScheduler::tile_seconds) {
        edge *= 2;
    }
    return edge;
}

/// The picture cut into squares from its top left corner, those near its middle first.
std::deque<render::Tile> cut(int width, int height, int edge) {
    std::deque<render::Tile> tiles;
    for (int y = 0; y < height; y += edge) {
        for (int x = 0; x < width; x += edge) {
            tiles.push_back({x, y, std::min(edge, width - x), std::min(edge, height - y)});
        }
    }
    const auto distance = [&](const render::Tile& tile) {
        return std::hypot(tile.x + 0.5 * tile.width - 0.5 * width,
                          tile.y + 0.5 * tile.height - 0.5 * height);
    };
    std::stable_sort(tiles.begin(), tiles.end(), [&](const render::Tile& a, const render::Tile& b) {
        return distance(a) < distance(b);
    });
    return tiles;
}

}  // namespace

void PictureScheduler::resize(int width, int height, double now) {
    if (width == width_ && height == height_) return;
    width_ = width;
    height_ = height;
    sweep_.reset();
    change(now);
}

void PictureScheduler::change(double now, render::Pass first) {
    pass_ = complete() ? first : std::min(pass_, first);
    ++version_;
    changed_ = now;
}

void PictureScheduler::restart(double now) {
    sweep_.reset();
    costs_ = {};
    change(now);
}

std::optional<DrawingStep> PictureScheduler::next(double now) {
    if (sweep_ && sweep_->divisor == 1 && sweep_->version != version_) sweep_.reset();
    if (!sweep_) {
        if (wait(now) > 0) return std::nullopt;
        const int divisor = coarse_version_ == version_ ? 1 : chosen_divisor();
        sweep_ = new_sweep(divisor);
    }
    split_costly_front();
    return DrawingStep{.divisor = sweep_->divisor,
                       .width = sweep_->width,
                       .height = sweep_->height,
                       .tile = sweep_->tiles.front(),
                       .pass = sweep_->pass,
                       .first = !sweep_->begun,
                       .last = sweep_->tiles.size() == 1};
}

void PictureScheduler::done(const DrawingStep& step, double seconds) {
    assert(sweep_ && !sweep_->tiles.empty());
    sweep_->tiles.pop_front();
    sweep_->begun = true;
    sweep_->seconds += seconds;
    last_pixel_seconds_ = seconds / pixels(step.tile);
    if (!sweep_->tiles.empty()) return;
    const double pixel_seconds = sweep_->seconds / (static_cast<double>(step.width) * step.height);
    // What costs so much by all passes costs no more by some.
    for (auto pass = static_cast<std::size_t>(step.pass); pass < costs_.size(); ++pass)
        if (!costs_[pass].known) costs_[pass].pixel_seconds = pixel_seconds;
    costs_[static_cast<std::size_t>(step.pass)] = {pixel_seconds, true};
    if (step.full()) {
        full_version_ = sweep_->version;
        if (step.pass == render::Pass::geometry) full_seconds_ = sweep_->seconds;
    }
    coarse_version_ = sweep_->version;
    sweep_.reset();
}

double PictureScheduler::wait(double now) const {
    constexpr double never = std::numeric_limits<double>::infinity();
    if (width_ <= 0 || height_ <= 0 || version_ == 0) return never;
    if (sweep_ && (sweep_->divisor > 1 || sweep_->version == version_)) return 0;
    if (full_version_ == version_) return never;
    if (coarse_version_ != version_) return 0;
    return std::max(0.0, changed_ + rest_seconds - now);
}

int PictureScheduler::chosen_divisor() const {
    const double whole = static_cast<double>(width_) * height_ * cost().pixel_seconds;
    if (costs_[0].known && whole <= immediate_seconds) return 1;
    for (const int divisor : divisors) {
        if (divisor > 1 && whole / (divisor * divisor) <= coarse_seconds) return divisor;
    }
    return divisors.back();
}

PictureScheduler::Sweep PictureScheduler::new_sweep(int divisor) const {
    const int width = std::max(1, width_ / divisor), height = std::max(1, height_ / divisor);
    const int edge = costs_[0].known ? edge_for(cost().pixel_seconds) : first_edge;
    return {.version = version_,
            .pass = pass_,
            .divisor = divisor,
            .width = width,
            .height = height,
            .tiles = cut(width, height, edge)};
}

void PictureScheduler::split_costly_front() {
    // Four times over the aim is a tile that the user notices.
    render::Tile tile = sweep_->tiles.front();
    while (sweep_->begun && std::min(tile.width, tile.height) >= 2 * smallest_edge &&
           pixels(tile) * last_pixel_seconds_ > 4 * tile_seconds) {
        const int left = tile.width / 2, top = tile.height / 2;
        const int right = tile.width - left, bottom = tile.height - top;
        sweep_->tiles.pop_front();
        sweep_->tiles.push_front({tile.x + left, tile.y + top, right, bottom});
        sweep_->tiles.push_front({tile.x, tile.y + top, left, bottom});
        sweep_->tiles.push_front({tile.x + left, tile.y, right, top});
        sweep_->tiles.push_front({tile.x, tile.y, left, top});
        tile = sweep_->tiles.front();
    }
}

}  // namespace studio
