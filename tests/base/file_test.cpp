// SPDX-License-Identifier: MIT
// Whole files: what is read, what is left after a failure, and what people are told.
#include "base/file.h"

#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

#include <gtest/gtest.h>

#include "base/temporary_folder.h"

namespace {

namespace fs = std::filesystem;

constexpr std::size_t enough = 1 << 20;

std::string content(const fs::path& path) {
    const base::Result<std::string> text = base::read_text(path, enough);
    EXPECT_TRUE(text);
    return text ? *text : std::string();
}

std::string problem(const base::Status& status) {
    EXPECT_FALSE(status);
    return status ? std::string() : status.problems().at(0).message;
}

std::string problem(const base::Result<std::string>& text) {
    EXPECT_FALSE(text);
    return text ? std::string() : text.problems().at(0).message;
}

TEST(File, comes_back_as_written) {
    const TemporaryFolder folder;
    const std::string bytes("line\r\n\0\xFF end", 12);
    ASSERT_TRUE(base::write_atomically(folder / "a", bytes));
    EXPECT_EQ(content(folder / "a"), bytes);
    ASSERT_TRUE(base::write_atomically(folder / "a", ""));
    EXPECT_EQ(content(folder / "a"), "");
    EXPECT_EQ(folder.size(), 1u);
}

TEST(File, of_many_bytes_comes_back_as_written) {
    const TemporaryFolder folder;
    std::string bytes(300001, '\0');
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * 31 + i / 997);
    ASSERT_TRUE(base::write_atomically(folder / "a", bytes));
    EXPECT_EQ(content(folder / "a"), bytes);
}

TEST(File, is_written_into_the_current_folder_by_its_bare_name) {
    const TemporaryFolder folder;
    const fs::path before = fs::current_path();
    fs::current_path(folder.path());
    const bool written{base::write_atomically("bare", "x")};
    fs::current_path(before);
    ASSERT_TRUE(written);
    EXPECT_EQ(content(folder / "bare"), "x");
}

TEST(File, in_a_missing_folder_is_an_error_that_names_the_folder) {
    const TemporaryFolder folder;
    const std::string inner = (folder / "no").string();
    EXPECT_EQ(problem(base::write_atomically(folder / "no" / "a.png", "x")),
              "cannot write '" + inner + "/a.png': the folder '" + inner +
                  "' does not exist; create it or choose another");
    EXPECT_EQ(folder.size(), 0u);
}

TEST(File, below_a_file_is_an_error_that_says_so) {
    const TemporaryFolder folder;
    ASSERT_TRUE(base::write_atomically(folder / "file", "x"));
    EXPECT_EQ(problem(base::write_atomically(folder / "file" / "a", "y")),
              "cannot write '" + (folder / "file" / "a").string() + "': '" +
                  (folder / "file").string() + "' is not a folder; choose another");
}

TEST(File, is_not_written_over_a_directory) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "sub");
    EXPECT_EQ(problem(base::write_atomically(folder / "sub", "x")),
              "cannot write '" + (folder / "sub").string() + "': it is a directory; name a file");
    EXPECT_TRUE(fs::is_directory(folder / "sub"));
    EXPECT_EQ(folder.size(), 1u);
}

TEST(File, without_a_name_is_an_error) {
    EXPECT_EQ(problem(base::write_atomically("", "x")),
              "cannot write a file without a name; give it one");
}

TEST(File, keeps_its_old_content_when_the_new_one_does_not_fit) {
    const TemporaryFolder folder;
    ASSERT_TRUE(base::write_atomically(folder / "a", "old"));
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit small = before;
    small.rlim_cur = 4096;
    setrlimit(RLIMIT_FSIZE, &small);
    const base::Status status = base::write_atomically(folder / "a", std::string(100000, 'n'));
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(problem(status), "cannot write '" + (folder / "a").string() +
                                   "': it would be larger than the system allows");
    EXPECT_EQ(content(folder / "a"), "old");
    EXPECT_EQ(folder.size(), 1u) << "the temporary file is still there";
}

TEST(File, that_is_a_device_is_written_to_and_stays_one) {
    ASSERT_TRUE(base::write_atomically("/dev/null", "x"));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    EXPECT_EQ(problem(base::write_atomically("/dev/full", "x")),
              "cannot write '/dev/full': the disk is full; free some space");
}

TEST(File, behind_a_link_is_replaced_and_the_link_stays) {
    const TemporaryFolder folder;
    ASSERT_TRUE(base::write_atomically(folder / "real", "old"));
    fs::create_symlink("real", folder / "link");
    ASSERT_TRUE(base::write_atomically(folder / "link", "new"));
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(content(folder / "real"), "new");
}

TEST(File, keeps_its_mode) {
    const TemporaryFolder folder;
    ASSERT_TRUE(base::write_atomically(folder / "a", "old"));
    fs::permissions(folder / "a", fs::perms(0640));
    ASSERT_TRUE(base::write_atomically(folder / "a", "new"));
    EXPECT_EQ(fs::status(folder / "a").permissions(), fs::perms(0640));
}

TEST(File, that_is_new_has_the_mode_of_the_process) {
    const TemporaryFolder folder;
    const mode_t before = umask(027);
    const bool written{base::write_atomically(folder / "a", "x")};
    umask(before);
    ASSERT_TRUE(written);
    EXPECT_EQ(fs::status(folder / "a").permissions(), fs::perms(0640));
}

TEST(File, that_is_missing_is_an_error_on_reading) {
    const TemporaryFolder folder;
    EXPECT_EQ(
        problem(base::read_text(folder / "no", enough)),
        "cannot read '" + (folder / "no").string() + "': there is no such file; check the name");
}

TEST(File, that_is_a_directory_is_an_error_on_reading) {
    const TemporaryFolder folder;
    EXPECT_EQ(problem(base::read_text(folder.path(), enough)),
              "cannot read '" + folder.path().string() + "': it is a directory; name a file");
}

TEST(File, is_read_up_to_the_limit_and_no_further) {
    const TemporaryFolder folder;
    ASSERT_TRUE(base::write_atomically(folder / "a", std::string(100, 'x')));
    EXPECT_TRUE(base::read_text(folder / "a", 100));
    EXPECT_EQ(problem(base::read_text(folder / "a", 99)),
              "cannot read '" + (folder / "a").string() + "': it is larger than 99 bytes");
    EXPECT_FALSE(base::read_text("/dev/zero", 1000));
}

}  // namespace
