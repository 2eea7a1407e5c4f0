// SPDX-License-Identifier: MIT
// The parts of the window. Each shows a piece of the workspace with ImGui, inside the frame at
// hand, and changes it as the user asks; undo and the picture follow from the changed document.
#pragma once

#include "studio/workspace.h"

namespace studio {

/// The editor, and below it what the compiler says.
void show_formula_panel(Workspace& workspace);
/// A slider for each parameter of the formula, and the time.
void show_parameter_panel(Workspace& workspace);
/// Tracer, precision, effects, and the region that is looked at.
void show_render_panel(Workspace& workspace);
/// Lights and the light from everywhere.
void show_light_panel(Workspace& workspace);
/// The table of materials.
void show_material_panel(Workspace& workspace);
/// The camera as numbers, title and description.
void show_camera_panel(Workspace& workspace);
void show_document_panel(Workspace& workspace);
/// Shipped presets and the user's own.
void show_preset_panel(Workspace& workspace);
/// How wrong the picture is, and what other settings would cost and buy.
void show_accuracy_panel(Workspace& workspace);
void show_accuracy_plot(Workspace& workspace);
/// The picture, and the camera by mouse on it.
void show_picture(Workspace& workspace);
void show_status_bar(const Workspace& workspace);
/// The newest messages over the picture, if there are any, and the log of all.
bool has_messages_to_show(const Workspace& workspace);
void show_messages(Workspace& workspace);
void show_log(Workspace& workspace);
void show_help(Workspace& workspace);
void show_menu_bar(Workspace& workspace);
/// Whichever dialog is open.
void show_dialogs(Workspace& workspace);

}  // namespace studio
