// SPDX-License-Identifier: MIT
// A whole picture at once, for the command line, screenshots and tests.
#pragma once

#include <functional>
#include <vector>

#include "base/result.h"
#include "image/image.h"
#include "render/canvas.h"
#include "render/context.h"

namespace render {

/// Everything that is known about the pixels of a still. Parts that the program does not write are
/// empty.
struct Still {
    image::Picture picture;
    image::Image<float, 4> geometry;
    image::Image<float, 4> normal;
    double link_seconds = 0;
    double first_frame_seconds = 0;     ///< from the first draw to finished; link_seconds is apart
    std::vector<double> frame_seconds;  ///< the same for each repeat; reading back is in none
};

/// Largest width and height of a full picture, and most pixels of a part that is drawn at once.
inline constexpr int largest_side = 32768;
inline constexpr long long most_pixels = 16384LL * 16384LL;

/// Draws the view in parts that fit the driver, `1 + repeat` times, and reads it back once.
/// `frame_of` is asked for the frame of each part: the view with the same full picture and a
/// smaller region. The context must be current. Errors: a program that does not link, sizes out of
/// range, a region outside of the picture, no memory, a driver that gives up.
base::Result<Still> draw_still(Context& context, const shader::ProgramSource& source,
                               const shader::FieldNumbers& numbers,
                               const std::function<Frame(const View&)>& frame_of, const View& view,
                               const shader::Outputs& outputs, int repeat = 0);

}  // namespace render
