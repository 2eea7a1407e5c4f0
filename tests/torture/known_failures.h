// SPDX-License-Identifier: MIT
// How many pixels each tracer gets wrong in each scene, as recorded in known_failures.json. The
// numbers may only shrink.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>

#include "base/result.h"
#include "oracle/metrics.h"

namespace torture {

/// Of one tracer in one scene: pixels outside of what is undecided or fragile.
struct Failures {
    std::size_t missed = 0;
    std::size_t phantom = 0;
    std::size_t moved = 0;
    std::size_t unresolved = 0;  ///< the tracer gave up; judged by what it shows as well

    friend bool operator==(const Failures&, const Failures&) = default;
};
Failures failures_of(const oracle::Metrics& metrics);

struct SceneRecord {
    std::size_t compared = 0;  ///< pixels that tracers are held to
    std::size_t undecided = 0;
    std::size_t fragile = 0;
    std::map<std::string, Failures> tracers;

    friend bool operator==(const SceneRecord&, const SceneRecord&) = default;
};
using Records = std::map<std::string, SceneRecord>;  ///< by scene

/// What another driver may add to a recorded number: its functions round elsewhere, and a pixel
/// that is on the verge falls to the other side. Two pixels, or 5 %.
std::size_t allowance(std::size_t recorded);

/// Whether a number is above what is allowed, in any of the four.
bool is_worse(const Failures& now, const Failures& recorded);
/// Whether the sum of wrong pixels is below what is recorded by more than the allowance.
bool is_better(const Failures& now, const Failures& recorded);

/// The smaller of each number.
Failures shrunk(const Failures& now, const Failures& recorded);

base::Result<Records> read_records(const std::filesystem::path& path);
/// A line a tracer; the same records give the same bytes.
std::string records_text(const Records& records);

}  // namespace torture
