// SPDX-License-Identifier: MIT
#include "studio/picture_statistics.h"

#include <algorithm>
#include <cmath>

#include "shader/program_source.h"

namespace studio {

PictureStatistics statistics(const image::Image<float, 4>& geometry) {
    PictureStatistics result;
    const std::size_t count = geometry.values.size() / 4;
    double sum = 0;
    float most = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const float* pixel = &geometry.values[4 * i];
        sum += pixel[1];
        most = std::max(most, pixel[1]);
        switch (static_cast<shader::Status>(std::lround(pixel[2]))) {
            case shader::Status::miss:
                ++result.missed;
                break;
            case shader::Status::hit:
                ++result.hit;
                break;
            case shader::Status::unresolved:
                ++result.unresolved;
                break;
        }
    }
    if (count > 0) result.mean_steps = sum / static_cast<double>(count);
    result.most_steps = static_cast<int>(most);
    return result;
}

}  // namespace studio
