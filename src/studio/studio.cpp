// SPDX-License-Identifier: MIT
#include "studio/studio.h"

#include <exception>
#include <string>

#include <fmt/format.h>

#include "studio/event_loop.h"
#include "studio/window.h"

namespace studio {

base::Status run(const Options& options) {
    try {
        auto window = Window::open(options.width, options.height);
        if (!window) return window.problems();
        EventLoop loop(**window, options);
        while (loop.step()) {
        }
        return base::Done{};
    } catch (const std::exception& exception) {
        return base::error(fmt::format("the studio has failed: {}", exception.what()));
    }
}

}  // namespace studio
