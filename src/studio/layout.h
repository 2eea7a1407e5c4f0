// SPDX-License-Identifier: MIT
// Where the panels stand in the window.
#pragma once

#include "studio/workspace.h"

namespace studio {

/// Shows the whole interface: menu on top, formula and tabs in the left column, the picture in the
/// middle, presets in the right column, the status at the bottom. Columns can be dragged wider.
void show_interface(Workspace& workspace);

}  // namespace studio
