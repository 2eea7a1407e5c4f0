// SPDX-License-Identifier: MIT
// The same work for many things, on several cores. Internal to the library.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace analysis {

/// Calls `work(worker, i)` once for each i below `count`, on at most `threads` threads, each with a
/// worker of its own from `make_worker()`. Where work(worker, i) depends on i alone and writes to
/// places of its own, the result is the same for any number of threads. A thread takes `chunk` of
/// them at a time. Nothing may throw.
template <class MakeWorker, class Work>
void in_parallel(std::size_t count, int threads, MakeWorker make_worker, Work work,
                 std::size_t chunk = 64) {
    std::atomic<std::size_t> next = 0;
    const auto run = [&] {
        if (next >= count) return;
        auto worker = make_worker();
        for (std::size_t begin = next.fetch_add(chunk); begin < count;
             begin = next.fetch_add(chunk)) {
            for (std::size_t i = begin; i < std::min(begin + chunk, count); ++i) work(worker, i);
        }
    };
    const std::size_t useful = (count + chunk - 1) / chunk;
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < std::min<std::size_t>(useful, static_cast<std::size_t>(threads));
         ++i) {
        others.emplace_back(run);
    }
    run();
}

}  // namespace analysis
