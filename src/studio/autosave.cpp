// SPDX-License-Identifier: MIT
#include "studio/autosave.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "base/file.h"
#include "scene/preset.h"
#include "studio/document_file.h"

namespace studio {
namespace {

namespace fs = std::filesystem;

/// Takes a lock that ends with the process; -1 if somebody else holds it.
int take_lock(const fs::path& file) {
    const int lock = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (lock < 0) return -1;
    if (flock(lock, LOCK_EX | LOCK_NB) == 0) return lock;
    close(lock);
    return -1;
}

}  // namespace

fs::path state_folder() {
    const char* state = std::getenv("XDG_STATE_HOME");
    if (state && state[0] == '/') return fs::path(state) / "zeroset";
    const char* home = std::getenv("HOME");
    return home ? fs::path(home) / ".local" / "state" / "zeroset" : fs::path();
}

Autosave::Autosave() {
    const fs::path folder = state_folder();
    if (folder.empty() || !make_parent_folder(folder / "autosave.json")) return;
    for (int number = 1; number <= most_files; ++number) {
        const std::string name = number == 1 ? "autosave" : fmt::format("autosave-{}", number);
        lock_ = take_lock(folder / (name + ".lock"));
        if (lock_ < 0) continue;
        file_ = folder / (name + ".json");
        return;
    }
}

Autosave::~Autosave() {
    std::error_code ignored;
    if (!file_.empty()) fs::remove(file_, ignored);
    if (lock_ >= 0) close(lock_);
}

std::optional<scene::Document> Autosave::recover() const {
    if (file_.empty()) return std::nullopt;
    const auto text = base::read_text(file_, scene::largest_preset);
    if (!text) return std::nullopt;
    auto preset = scene::read_preset(*text);
    if (!preset) return std::nullopt;
    return std::move(preset->document);
}

base::Status Autosave::update(const scene::Document& document, bool unsaved, double seconds) {
    if (file_.empty()) return base::Done{};
    if (!unsaved) {
        pending_.reset();
        if (written_) {
            std::error_code ignored;
            fs::remove(file_, ignored);
            written_.reset();
        }
        return base::Done{};
    }
    if (written_ == document) {
        pending_.reset();
        return base::Done{};
    }
    if (!pending_) due_ = seconds + pause_seconds;
    pending_ = document;
    return seconds < due_ ? base::Done{} : write(document);
}

double Autosave::wait(double seconds) const {
    if (!pending_) return std::numeric_limits<double>::infinity();
    return std::max(0.0, due_ - seconds);
}

base::Status Autosave::write(const scene::Document& document) {
    // What could not be written is not tried again before the next change.
    written_ = document;
    pending_.reset();
    auto status = base::write_atomically(file_, scene::write_preset(document));
    if (status || complained_) return base::Done{};
    complained_ = true;
    base::Diagnostics problems = status.problems();
    problems.push_back(base::error("unsaved work is not kept safe; save it yourself"));
    return problems;
}

}  // namespace studio
