// SPDX-License-Identifier: MIT
// A copy of unsaved work on the disk, for the case that the studio or the machine goes down.
#pragma once

#include <filesystem>
#include <optional>

#include "base/result.h"
#include "scene/document.h"

namespace studio {

/// $XDG_STATE_HOME/zeroset, by default ~/.local/state/zeroset.
std::filesystem::path state_folder();

/// One file for each studio that runs at the same time: autosave.json, autosave-2.json, and so on,
/// the first that no other one holds. Copies are written at most every few seconds, and removed
/// when nothing is unsaved.
class Autosave {
public:
    static constexpr double pause_seconds = 3;
    static constexpr int most_files = 8;

    Autosave();
    /// Removes the copy: leaving in an orderly way is the user's decision about it.
    ~Autosave();
    Autosave(const Autosave&) = delete;
    Autosave& operator=(const Autosave&) = delete;

    /// What a studio that was not closed has left, if anything; asked for at the start, once.
    std::optional<scene::Document> recover() const;

    /// Writes a copy if the document has been unsaved and unchanged for a while, or unsaved for
    /// long; removes it once all is saved. Problems are answered once, not again and again.
    base::Status update(const scene::Document& document, bool unsaved, double seconds);
    /// Seconds until `update` has something to do; infinity for never.
    double wait(double seconds) const;

private:
    base::Status write(const scene::Document& document);

    std::filesystem::path file_;  ///< empty: no copy is possible
    int lock_ = -1;
    std::optional<scene::Document> written_, pending_;
    double due_ = 0;
    bool complained_ = false;
};

}  // namespace studio
