// SPDX-License-Identifier: MIT
// The off-screen context that tests draw in.
#pragma once

#include <cstdlib>
#include <memory>

#include "render/context.h"

/// OSMesa, which is there on every machine, unless the environment says ZEROSET_TEST_BACKEND=egl:
/// then the graphics card.
inline base::Result<std::unique_ptr<render::Context>> open_headless() {
    const char* backend = std::getenv("ZEROSET_TEST_BACKEND");
    return render::open_headless(backend ? backend : "osmesa");
}
