// SPDX-License-Identifier: MIT
// Opening and saving the workspace's document, and the names of files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.h"
#include "studio/workspace.h"

namespace studio {

/// Opens a preset file in the place of the document, whatever becomes of that. Warnings go to the
/// workspace's messages. On an error nothing changes.
base::Status open_file(Workspace& workspace, const std::filesystem::path& file);

/// Writes the document; the file is the document's from then on. Folders are made as needed.
/// Values that suit no parameter of the formula are dropped, if the formula is understood.
base::Status save_file(Workspace& workspace, const std::filesystem::path& file);

/// The file that a user means by a name in "Save as": an absolute path and one that begins with
/// `~/`, `./` or `../` as they stand, anything else below the folder of the user's presets; with
/// the extension .json.
base::Result<std::filesystem::path> preset_path(std::string_view name);

/// The same for a picture: anything else below the folder of pictures; with the extension .png.
base::Result<std::filesystem::path> picture_path(std::string_view name);

/// Where screenshots go: `zeroset` in ~/Pictures if there is such a folder, else
/// $XDG_DATA_HOME/zeroset/screenshots.
std::filesystem::path pictures_folder();

/// A path in the pictures' folder that is not taken yet: NAME-1.png, NAME-2.png, and so on.
std::filesystem::path fresh_picture_path(const std::string& name);

/// Makes the folder that a file shall lie in.
base::Status make_parent_folder(const std::filesystem::path& file);

}  // namespace studio
