// SPDX-License-Identifier: MIT
// The picture in the window: draws what PictureScheduler asks for into textures, and says which of
// them make up the newest picture.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "render/canvas.h"
#include "render/program.h"
#include "scene/document.h"
#include "shader/field_numbers.h"
#include "studio/picture_scheduler.h"
#include "studio/picture_statistics.h"

namespace studio {

/// Everything that a picture is made of besides the program. Two pictures with equal frames and
/// numbers are equal.
struct WantedPicture {
    scene::Document document;
    scene::Camera camera;
    shader::FieldNumbers field_numbers;
    int width = 0, height = 0;
};

/// Which textures to show: the base over the whole area, then the tiles of the full picture. Row 0
/// of a texture is the top. A texture 0 is none.
struct PictureLayers {
    GLuint base = 0;
    GLuint full = 0;
    int width = 0, height = 0;  ///< of the full picture
    const std::vector<render::Tile>* tiles = nullptr;
};

/// What is known about a complete full picture.
struct PictureReport {
    int width = 0, height = 0;
    double seconds = 0;  ///< spent drawing it, without pauses between tiles
    PictureStatistics statistics;
    /// Pixels whose ray took a step that is not proven; none if the Lipschitz scale is 1 or more.
    std::optional<std::size_t> at_risk;
};

/// How much work drawing was, in pixels since the beginning, coarse ones as well.
struct PictureWork {
    long long traced = 0;  ///< primary rays
    long long shaded = 0;  ///< lit, with shadow rays where there are shadows
    long long shown = 0;   ///< pixels of pictures

    friend bool operator==(const PictureWork&, const PictureWork&) = default;
};

/// What drawing has brought: some tiles of a picture, or a whole one.
enum class PictureNews { none, tiles, whole };

/// Owns textures and the program: the window's context must be current for every call. The
/// functions must outlive it.
class LivePicture {
public:
    explicit LivePicture(const render::Gl& gl) : gl_(&gl) {}

    /// The program of all further pictures; what is shown stays until there is something new.
    void set_program(std::unique_ptr<render::Program> program, double now);
    /// Says what is to be drawn. Nothing is drawn again if that is what was drawn.
    void want(const WantedPicture& wanted, double now);

    /// Draws for about so many seconds, and answers what there is new to show. After an error
    /// nothing is drawn until something else is wanted.
    base::Result<PictureNews> work(double budget, double now);
    /// Seconds until `work` has something to do: 0 for now, infinity for never.
    double wait(double now) const;

    PictureLayers layers() const;
    /// True if the full picture of what is wanted is on show.
    bool complete() const { return !program_ || scheduler_.complete(); }
    const std::optional<PictureReport>& report() const { return report_; }
    const PictureWork& work_done() const { return work_; }

private:
    base::Result<PictureNews> draw_for(double budget, double now);
    base::Status prepare(const DrawingStep& step);
    base::Status draw(const DrawingStep& step);
    bool report_is_due(double now) const;
    void make_report();

    const render::Gl* gl_;
    std::unique_ptr<render::Program> program_;
    PictureScheduler scheduler_;
    std::optional<WantedPicture> wanted_;
    std::optional<render::Frame> wanted_frame_;
    std::optional<WantedPicture> drawn_;  ///< the picture whose tiles are being drawn
    std::optional<render::Frame> drawn_frame_;

    std::optional<render::Canvas> full_, coarse_, next_coarse_;
    bool coarse_shown_ = false;
    std::vector<render::Tile> full_tiles_;
    std::optional<PictureReport> report_;
    PictureWork work_;
    bool reported_ = true;
    bool failed_ = false;
};

}  // namespace studio
