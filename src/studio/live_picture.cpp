// SPDX-License-Identifier: MIT
#include "studio/live_picture.h"

#include <chrono>
#include <cmath>
#include <utility>

#include "render/passes.h"
#include "studio/live_outputs.h"

namespace studio {
namespace {

double clock_seconds() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

bool has_size(const std::optional<render::Canvas>& canvas, int width, int height) {
    return canvas && canvas->width() == width && canvas->height() == height;
}

}  // namespace

void LivePicture::set_program(std::unique_ptr<render::Program> program, double now) {
    program_ = std::move(program);
    scheduler_.restart(now);
    failed_ = false;
}

void LivePicture::want(const WantedPicture& wanted, double now) {
    if (wanted.width <= 0 || wanted.height <= 0) return;
    const render::Frame frame =
        render::frame(wanted.document, wanted.camera, render::whole(wanted.width, wanted.height));
    std::optional<render::Pass> changed = render::Pass::geometry;
    if (wanted_frame_ && wanted.field_numbers == wanted_->field_numbers)
        changed = render::first_changed(*wanted_frame_, frame);
    if (!changed) return;
    wanted_ = wanted;
    wanted_frame_ = frame;
    failed_ = false;
    scheduler_.resize(wanted.width, wanted.height, now);
    scheduler_.change(now, *changed);
}

base::Result<PictureNews> LivePicture::work(double budget, double now) {
    if (!program_ || !wanted_ || failed_) return PictureNews::none;
    auto news = draw_for(budget, now);
    failed_ = !news;
    return news;
}

base::Result<PictureNews> LivePicture::draw_for(double budget, double now) {
    PictureNews news = PictureNews::none;
    const double start = clock_seconds();
    double spent = 0;
    while (spent < budget) {
        const auto step = scheduler_.next(now + spent);
        if (!step) break;
        if (step->first) {
            if (auto status = prepare(*step); !status) return status.problems();
        }
        const double before = clock_seconds();
        if (auto status = draw(*step); !status) return status.problems();
        const double after = clock_seconds();
        scheduler_.done(*step, after - before);
        if (step->last) {
            news = PictureNews::whole;
        } else if (step->full() && news == PictureNews::none) {
            news = PictureNews::tiles;
        }
        spent = after - start;
    }
    if (report_is_due(now + spent)) {
        make_report();
        news = PictureNews::whole;
    }
    return news;
}

double LivePicture::wait(double now) const {
    if (!program_ || !wanted_ || failed_) return std::numeric_limits<double>::infinity();
    if (!reported_ && scheduler_.complete()) {
        return scheduler_.resting(now) ? 0 : PictureScheduler::rest_seconds / 2;
    }
    return scheduler_.wait(now);
}

PictureLayers LivePicture::layers() const {
    PictureLayers layers;
    if (coarse_shown_ && coarse_) layers.base = coarse_->picture_texture();
    if (full_) {
        layers.full = full_->picture_texture();
        layers.width = full_->width();
        layers.height = full_->height();
    }
    layers.tiles = &full_tiles_;
    return layers;
}

/// Takes what is wanted now as the picture to draw, and makes room for it.
base::Status LivePicture::prepare(const DrawingStep& step) {
    drawn_ = wanted_;
    const bool traced = step.pass == render::Pass::geometry;
    // What is kept is the full picture's, whatever the size in which it is drawn.
    const render::View view = traced ? render::whole(step.width, step.height)
                                     : render::whole(full_->width(), full_->height());
    drawn_frame_ = render::frame(drawn_->document, drawn_->camera, view);
    std::optional<render::Canvas>& canvas = step.full() ? full_ : next_coarse_;
    if (!has_size(canvas, step.width, step.height)) {
        if (step.full() && full_ && !coarse_shown_ && !full_tiles_.empty()) {
            // After a change of size the old picture, stretched, is the best there is to show.
            coarse_ = std::move(full_);
            coarse_shown_ = true;
        }
        if (step.full()) full_tiles_.clear();
        canvas.reset();
        auto made = render::Canvas::create(*gl_, step.width, step.height, live_outputs);
        if (!made) return made.problems();
        canvas = std::move(*made);
        // Only a coarse picture is shown larger than it is.
        gl_->TextureParameteri(canvas->picture_texture(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        gl_->TextureParameteri(canvas->picture_texture(), GL_TEXTURE_MAG_FILTER,
                               step.full() ? GL_NEAREST : GL_LINEAR);
    }
    return base::Done{};
}

base::Status LivePicture::draw(const DrawingStep& step) {
    std::optional<render::Canvas>& canvas = step.full() ? full_ : next_coarse_;
    if (!canvas || !drawn_frame_) return base::error("the live picture has no canvas");
    canvas->draw_from(step.pass, step.pass == render::Pass::geometry ? *canvas : *full_, *program_,
                      *drawn_frame_, drawn_->field_numbers, step.tile);
    canvas->finish();
    const long long pixels = static_cast<long long>(step.tile.width) * step.tile.height;
    if (step.pass <= render::Pass::geometry) work_.traced += pixels;
    if (step.pass <= render::Pass::light) work_.shaded += pixels;
    work_.shown += pixels;
    if (!step.full()) {
        if (step.last) {
            std::swap(coarse_, next_coarse_);
            coarse_shown_ = true;
            full_tiles_.clear();
        }
        return base::Done{};
    }
    full_tiles_.push_back(step.tile);
    if (step.last) {
        full_tiles_ = {{0, 0, step.width, step.height}};
        reported_ = false;
    }
    return base::Done{};
}

bool LivePicture::report_is_due(double now) const {
    return !reported_ && scheduler_.complete() && scheduler_.resting(now);
}

void LivePicture::make_report() {
    std::optional<std::size_t> at_risk;
    // Told by the program only then (SceneBuilder).
    if (drawn_->document.settings.lipschitz < 1) at_risk = guessed(full_->read_normal());
    report_ = PictureReport{.width = full_->width(),
                            .height = full_->height(),
                            .seconds = scheduler_.full_seconds(),
                            .statistics = statistics(full_->read_geometry()),
                            .at_risk = at_risk};
    reported_ = true;
}

}  // namespace studio
