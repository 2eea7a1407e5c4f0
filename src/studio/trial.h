// SPDX-License-Identifier: MIT
// One frame of the present view in the size of a reference, drawn to be timed and judged.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/result.h"
#include "compile/compile.h"
#include "oracle/metrics.h"
#include "oracle/reference.h"
#include "scene/document.h"
#include "studio/marked_areas.h"

namespace studio {

/// How wrong a trial is, and where.
struct Judged {
    oracle::Metrics metrics;  ///< without the judgement of every pixel
    std::vector<MarkedArea> areas;
};

struct TrialRequest {
    std::uint64_t id = 0;
    std::shared_ptr<const compile::Formula> formula;
    scene::Document document;  ///< with its camera
    std::shared_ptr<const oracle::Reference> reference;
    bool judged = false;          ///< otherwise it is timed only
    double expected_seconds = 0;  ///< 0: not known
};

struct TrialAnswer {
    std::uint64_t id = 0;
    bool given_up = false;  ///< for something more urgent; to be asked again
    base::Diagnostics problems{};
    double seconds = 0;  ///< from draw to finished; linking and reading back are not in it
    std::shared_ptr<const Judged> judged{};
};

}  // namespace studio
