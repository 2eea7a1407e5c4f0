// SPDX-License-Identifier: MIT
// What menus, shortcuts and dialogs have in common: the commands of the studio.
#pragma once

#include "studio/workspace.h"

namespace studio {

/// Opens another document or ends the studio; asks first if something is unsaved.
void start(Workspace& workspace, const PendingAction& action);
/// The same without asking.
void carry_out(Workspace& workspace, const PendingAction& action);

/// Saves into the document's own file. Where it has none, or a shipped one, asks for a name.
void save(Workspace& workspace);
/// Asks for a name.
void save_as(Workspace& workspace);
/// Asks for a file.
void open_dialog(Workspace& workspace);
/// Asks for size and place of a picture.
void screenshot_dialog(Workspace& workspace);
/// Draws a picture of the size that was used last, under a fresh name.
void quick_screenshot(Workspace& workspace);
/// Moves the camera so that the whole region fills the picture.
void frame_all(Workspace& workspace);
/// Checks the picture against the reference, and shows the panel that tells what comes of it.
void check_accuracy(Workspace& workspace);

}  // namespace studio
