// SPDX-License-Identifier: MIT
#include "studio/actions.h"

#include "studio/document_file.h"

namespace studio {

void start(Workspace& workspace, const PendingAction& action) {
    if (!workspace.unsaved()) return carry_out(workspace, action);
    workspace.dialogs.pending = action;
    workspace.dialogs.show(Dialogs::Kind::unsaved);
}

void carry_out(Workspace& workspace, const PendingAction& action) {
    switch (action.kind) {
        case PendingAction::Kind::new_document:
            workspace.replace(first_document(), std::nullopt, false);
            workspace.view.focus_formula = true;
            return;
        case PendingAction::Kind::open:
            if (auto status = open_file(workspace, action.file); !status) {
                workspace.report_problems(status.problems());
            }
            return;
        case PendingAction::Kind::quit:
            workspace.quit = true;
            return;
    }
}

void save(Workspace& workspace) {
    if (!workspace.file || workspace.shipped) return save_as(workspace);
    if (auto status = save_file(workspace, *workspace.file); !status) {
        workspace.report_problems(status.problems());
    }
}

void save_as(Workspace& workspace) {
    workspace.dialogs.name = workspace.file ? workspace.file->stem().string() : "";
    workspace.dialogs.show(Dialogs::Kind::save_as);
}

void open_dialog(Workspace& workspace) {
    workspace.dialogs.name.clear();
    workspace.dialogs.show(Dialogs::Kind::open);
}

void screenshot_dialog(Workspace& workspace) {
    workspace.dialogs.still_path = fresh_picture_path(workspace.name()).string();
    workspace.dialogs.show(Dialogs::Kind::screenshot);
}

void quick_screenshot(Workspace& workspace) {
    workspace.dialogs.still_path = fresh_picture_path(workspace.name()).string();
    workspace.dialogs.still_wanted = true;
}

void frame_all(Workspace& workspace) {
    workspace.document.camera =
        scene::frame_from(workspace.camera(), workspace.document.bounds, workspace.area.aspect());
}

void check_accuracy(Workspace& workspace) {
    workspace.view.panels = workspace.view.accuracy = true;
    workspace.accuracy.wish = Accuracy::Wish::check;
}

}  // namespace studio
