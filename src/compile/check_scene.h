// SPDX-License-Identifier: MIT
// Warnings about what a scene would show.
#pragma once

#include "base/diagnostic.h"
#include "compile/compile.h"
#include "scene/document.h"

namespace compile {

/// Warnings, each with a proof for the document's parameters, time and bounds: nothing is in the
/// bounds, or anywhere in space; a solid fills the bounds; the formula does not depend on the
/// point; one of its comparisons is true everywhere or nowhere. Where a proof takes more than a
/// millisecond or so there is no warning. Spans are bytes of the formula's text.
base::Diagnostics check_scene(const Formula& formula, const scene::Document& document);

}  // namespace compile
