// SPDX-License-Identifier: MIT
// The thread that traces reference pictures, so that the window never waits for them.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "base/result.h"
#include "compile/compile.h"
#include "oracle/reference.h"
#include "oracle/trace.h"
#include "studio/reference_key.h"

namespace studio {

struct TracedReference {
    ReferenceKey key;
    /// What was traced, for drawing the same; none if the text is not understood.
    std::shared_ptr<const compile::Formula> formula{};
    std::shared_ptr<const oracle::Reference> reference{};  ///< none if there are problems
    base::Diagnostics problems{};
    double seconds = 0;
};

/// Traces one reference at a time. A newer request gives up the older one; what was given up is
/// never answered.
class ReferenceThread {
public:
    /// As oracle::trace.
    using Trace = std::function<base::Result<oracle::Reference>(
        const compile::Formula&, const scene::Document&, const oracle::Query&)>;

    /// `wake` is called, from any thread, when there is an answer, and now and then when there is
    /// progress.
    ReferenceThread(Trace trace, std::function<void()> wake);
    /// Gives up the work at hand, and waits until it has noticed.
    ~ReferenceThread();
    ReferenceThread(const ReferenceThread&) = delete;
    ReferenceThread& operator=(const ReferenceThread&) = delete;

    void start(ReferenceKey key);
    void cancel();

    /// True from `start` until the answer can be taken, or until it is cancelled.
    bool busy() const;
    /// The finished part of the work at hand.
    double progress() const { return progress_; }
    /// The answer, once.
    std::optional<TracedReference> take();

private:
    void run();
    TracedReference trace(ReferenceKey key, std::uint64_t turn);
    bool report(double part, std::uint64_t turn);

    Trace trace_;
    std::function<void()> wake_;
    std::atomic<std::uint64_t> turn_ = 0;  ///< of the newest request, or of the newest cancelling
    std::atomic<double> progress_ = 0;
    std::atomic<std::int64_t> reported_ = 0;  ///< when, in milliseconds

    mutable std::mutex mutex_;  ///< guards everything below
    std::condition_variable wanted_;
    bool stop_ = false;
    bool busy_ = false;
    std::optional<ReferenceKey> request_;
    std::optional<TracedReference> answer_;

    std::thread thread_;
};

}  // namespace studio
