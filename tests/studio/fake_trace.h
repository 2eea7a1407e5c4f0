// SPDX-License-Identifier: MIT
// A tracer of references that takes as long as a test wants.
#pragma once

#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <thread>

#include "studio/reference_thread.h"

/// Answers references in which the left half is hit at depth 1 and the right half is missed.
struct FakeTrace {
    std::atomic<int> begun = 0, given_up = 0;
    std::atomic<bool> holds = false;  ///< work goes on until this is false, or until it is given up
    std::atomic<bool> fails = false;

    studio::ReferenceThread::Trace function() {
        return [this](const compile::Formula&, const scene::Document&,
                      const oracle::Query& query) -> base::Result<oracle::Reference> {
            ++begun;
            do {
                if (!query.progress(0.25)) {
                    ++given_up;
                    return base::error("given up");
                }
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            } while (holds);
            if (fails) return base::error("the picture is too steep");
            return halves(query.width, query.height);
        };
    }

    static oracle::Reference halves(int width, int height) {
        oracle::Reference reference;
        reference.width = width;
        reference.height = height;
        reference.pixel_width = 0.01;
        for (int i = 0; i < width * height; ++i) {
            const bool hit = 2 * (i % width) < width;
            const double depth = hit ? 1 : INFINITY;
            reference.pixels.push_back(
                {.verdict = hit ? oracle::Verdict::hit : oracle::Verdict::miss,
                 .object = hit ? 0 : -1,
                 .near = depth,
                 .far = depth});
        }
        return reference;
    }
};

/// Looks until the condition is true; false after a long time in vain.
inline bool comes_true(const std::function<bool()>& condition) {
    for (int i = 0; i < 20000; ++i) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
}
