// SPDX-License-Identifier: MIT
// Reading and writing of whole files by the system's own calls, which say why they fail.
#include "base/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <system_error>
#include <utility>

namespace base {
namespace {

namespace fs = std::filesystem;

/// An open file, closed at the end of its life.
class Handle {
public:
    explicit Handle(int number) : number_(number) {}
    ~Handle() {
        if (number_ >= 0) ::close(number_);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;

    explicit operator bool() const { return number_ >= 0; }
    int number() const { return number_; }
    /// Closes now; false if the system could not write everything after all.
    bool close() { return ::close(std::exchange(number_, -1)) == 0; }

private:
    int number_;
};

std::string quoted(const fs::path& path) {
    std::string text = path.string();
    text.insert(text.begin(), '\'');
    return text += '\'';
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// Why a folder cannot be used, or an empty text.
std::string folder_problem(const fs::path& folder) {
    std::error_code ignored;
    const fs::file_status status = fs::status(folder, ignored);
    if (status.type() == fs::file_type::not_found) {
        return "the folder " + quoted(folder) + " does not exist; create it or choose another";
    }
    if (status.type() != fs::file_type::directory && status.type() != fs::file_type::none) {
        return quoted(folder) + " is not a folder; choose another";
    }
    return {};
}

std::string reason_not_read(int code) {
    switch (code) {
        case ENOENT:
        case ENOTDIR:
            return "there is no such file; check the name";
        case EISDIR:
            return "it is a directory; name a file";
        case EACCES:
        case EPERM:
            return "no permission; make the file readable";
        default:
            return std::generic_category().message(code);
    }
}

std::string reason_not_written(const fs::path& path, int code) {
    const fs::path folder = folder_of(path);
    switch (code) {
        case ENOENT:
        case ENOTDIR: {
            const std::string problem = folder_problem(folder);
            return problem.empty() ? std::generic_category().message(code) : problem;
        }
        case EISDIR:
            return "it is a directory; name a file";
        case EACCES:
        case EPERM:
            return "no permission to write in the folder " + quoted(folder) + "; choose another";
        case EROFS:
            return "the disk is read-only; choose another folder";
        case ENOSPC:
        case EDQUOT:
            return "the disk is full; free some space";
        case EFBIG:
            return "it would be larger than the system allows";
        case ENAMETOOLONG:
            return "the name is too long; choose a shorter one";
        default:
            return std::generic_category().message(code);
    }
}

Diagnostic cannot_read(const fs::path& path, const std::string& why) {
    return error("cannot read " + quoted(path) + ": " + why);
}

Diagnostic cannot_write(const fs::path& path, const std::string& why) {
    return error("cannot write " + quoted(path) + ": " + why);
}

/// 0, or the system's error code.
int write_all(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(file, bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR) return errno;
        if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return 0;
}

/// A device or a pipe cannot be replaced, only written to.
int write_directly(const fs::path& path, std::string_view bytes) {
    Handle file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (!file) return errno;
    const int code = write_all(file.number(), bytes);
    return code == 0 && !file.close() ? errno : code;
}

/// A new file in a folder with a name that nobody else uses. O_EXCL, so that the process's mask of
/// modes applies as it does to any new file.
int create_temporary(const fs::path& folder, fs::path& path) {
    int number = -1;
    for (int attempt = 0; attempt < 1000; ++attempt) {
        path = folder / (".zeroset-" + std::to_string(::getpid()) + "-" + std::to_string(attempt));
        number = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (number >= 0 || errno != EEXIST) break;
    }
    return number;
}

/// Makes a rename last through a power failure. Some file systems cannot; the file is whole anyway.
void flush_folder(const fs::path& folder) {
    const Handle handle(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (handle) ::fsync(handle.number());
}

int replace(const fs::path& path, std::string_view bytes, std::optional<mode_t> mode) {
    const fs::path folder = folder_of(path);
    fs::path temporary;
    Handle file(create_temporary(folder, temporary));
    if (!file) return errno;
    int code = write_all(file.number(), bytes);
    if (code == 0 && mode && ::fchmod(file.number(), *mode) != 0) code = errno;
    if (code == 0 && ::fsync(file.number()) != 0) code = errno;
    if (code == 0 && !file.close()) code = errno;
    if (code == 0 && ::rename(temporary.c_str(), path.c_str()) != 0) code = errno;
    if (code != 0) {
        ::unlink(temporary.c_str());
        return code;
    }
    flush_folder(folder);
    return 0;
}

}  // namespace

Result<std::string> read_text(const fs::path& path, std::size_t max_bytes) {
    const Handle file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file) return cannot_read(path, reason_not_read(errno));
    std::string content;
    constexpr std::size_t piece = 64 * 1024;
    while (content.size() <= max_bytes) {
        const std::size_t before = content.size();
        content.resize(before + piece);
        const ssize_t count = ::read(file.number(), content.data() + before, piece);
        content.resize(before + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
        if (count == 0) return content;
        if (count < 0 && errno != EINTR) return cannot_read(path, reason_not_read(errno));
    }
    return cannot_read(path, "it is larger than " + std::to_string(max_bytes) + " bytes");
}

Status write_atomically(const fs::path& path, std::string_view bytes) {
    if (path.empty()) return error("cannot write a file without a name; give it one");
    std::error_code failure;
    fs::path target = path;
    if (fs::is_symlink(path, failure)) {
        target = fs::weakly_canonical(path, failure);
        if (failure) return cannot_write(path, "the link leads nowhere; remove it");
    }
    struct stat status {};
    const bool exists = ::stat(target.c_str(), &status) == 0;
    int code = 0;
    if ((exists && S_ISDIR(status.st_mode)) || !target.has_filename()) {
        code = EISDIR;
    } else if (exists && ::access(target.c_str(), W_OK) != 0) {
        return cannot_write(path, "no permission to change it; choose another name");
    } else if (exists && !S_ISREG(status.st_mode)) {
        code = write_directly(target, bytes);
    } else {
        code = replace(target, bytes,
                       exists ? std::optional<mode_t>(status.st_mode & 07777) : std::nullopt);
    }
    if (code != 0) return cannot_write(path, reason_not_written(target, code));
    return Done{};
}

}  // namespace base
