// SPDX-License-Identifier: MIT
#include "bench/judge.h"

#include <algorithm>

#include "oracle/marked_picture.h"
#include "oracle/metrics.h"
#include "shader/program_source.h"

namespace bench {
namespace {

oracle::Shot shot(const image::Image<float, 4>& geometry, const image::Image<float, 4>& normal) {
    oracle::Shot shot;
    shot.depth = image::Grey(geometry.width, geometry.height);
    shot.normal = image::Vectors(geometry.width, geometry.height);
    for (std::size_t i = 0; i < shot.depth.values.size(); ++i) {
        shot.depth.values[i] = geometry.values[4 * i];
        std::copy_n(&normal.values[4 * i], 3, &shot.normal.values[3 * i]);
        const auto status = static_cast<shader::Status>(geometry.values[4 * i + 2]);
        shot.gave_up.push_back(status == shader::Status::unresolved);
    }
    return shot;
}

Errors errors(const oracle::Metrics& m) {
    return {m.compared,
            m.undecided,
            m.fragile,
            m.missed,
            m.phantom,
            m.moved,
            m.depth_error.median,
            m.depth_error.percentile_99,
            m.depth_error.largest,
            m.normal_error.median,
            m.normal_error.percentile_99};
}

}  // namespace

base::Result<Judged> judge(const oracle::Reference& reference,
                           const image::Image<float, 4>& geometry,
                           const image::Image<float, 4>& normal) {
    const auto metrics = oracle::compare(reference, shot(geometry, normal));
    if (!metrics) return metrics.problems();
    return Judged{errors(*metrics), oracle::marked_picture(reference, *metrics)};
}

}  // namespace bench
