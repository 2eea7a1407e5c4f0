// SPDX-License-Identifier: MIT
// The machine that a run is made on.
#pragma once

#include "bench/report.h"
#include "render/context.h"

namespace bench {

/// Now; the context must be current.
Machine describe_machine(const render::Context& context, const std::string& backend);

}  // namespace bench
