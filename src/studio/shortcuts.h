// SPDX-License-Identifier: MIT
// Keys that work everywhere in the studio.
#pragma once

#include "studio/workspace.h"

namespace studio {

/// Carries out the commands whose keys have been pressed in this frame. Keys without Ctrl leave
/// text fields alone; nothing happens while a dialog is open.
void handle_shortcuts(Workspace& workspace);

}  // namespace studio
