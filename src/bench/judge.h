// SPDX-License-Identifier: MIT
// What a canvas shows, held against a reference.
#pragma once

#include "base/result.h"
#include "bench/report.h"
#include "image/image.h"
#include "oracle/reference.h"

namespace bench {

struct Judged {
    Errors errors;
    image::Picture picture;  ///< where it is wrong (oracle::marked_picture)
};

/// `geometry` and `normal` as shader::Outputs describes them. Error: another size than that of the
/// reference.
base::Result<Judged> judge(const oracle::Reference& reference,
                           const image::Image<float, 4>& geometry,
                           const image::Image<float, 4>& normal);

}  // namespace bench
