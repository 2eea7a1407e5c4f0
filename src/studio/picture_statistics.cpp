// SPDX-License-Identifier: MIT
#include "studio/picture_statistics.h"

#include <algorithm>
#include <cmath>

#include "shader/program_source.h"

namespace studio {

std::size_t guessed(const image::Image<float, 4>& normal) {
    std::size_t count = 0;
    for (std::size_t i = 3; i < normal.values.size(); i += 4) {
        const shader::Certificate what = shader::certificate_in(normal.values[i]);
        count += what == shader::Certificate::heuristic_hit ||
                 what == shader::Certificate::heuristic_miss;
    }
    return count;
}

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
