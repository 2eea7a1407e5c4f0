// SPDX-License-Identifier: MIT
// Which file the name of a preset means.
#include <stdlib.h>

#include <gtest/gtest.h>

#include "base/file.h"
#include "base/temporary_folder.h"
#include "scene/preset.h"

namespace {

namespace fs = std::filesystem;

/// An environment variable's value for one test.
class Variable {
public:
    Variable(const char* name, const std::string& value) : name_(name) {
        const char* before = getenv(name);
        if (before) before_ = before;
        had_one_ = before != nullptr;
        setenv(name, value.c_str(), 1);
    }
    ~Variable() {
        if (had_one_) {
            setenv(name_, before_.c_str(), 1);
        } else {
            unsetenv(name_);
        }
    }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

private:
    const char* name_;
    std::string before_;
    bool had_one_ = false;
};

/// A shipped folder with two presets and an own folder with one.
class FindPreset : public testing::Test {
protected:
    FindPreset()
        : shipped_("ZEROSET_PRESETS", (folder_ / "shipped").string()),
          data_("XDG_DATA_HOME", (folder_ / "data").string()) {
        add("shipped/surfaces/heart.json");
        add("shipped/default.json");
        add("shipped/notes.txt");
        add("data/zeroset/presets/mine.json");
    }

    void add(const std::string& name) {
        fs::create_directories((folder_ / name).parent_path());
        EXPECT_TRUE(base::write_atomically(folder_ / name, "{}"));
    }
    std::string found(const std::string& name) {
        const auto path = scene::find_preset(name);
        return path ? path->lexically_relative(folder_.path()).generic_string()
                    : path.problems().at(0).message;
    }

    TemporaryFolder folder_;
    Variable shipped_;
    Variable data_;
};

TEST_F(FindPreset, finds_shipped_and_own_ones_by_name) {
    EXPECT_EQ(found("heart"), "shipped/surfaces/heart.json");
    EXPECT_EQ(found("heart.json"), "shipped/surfaces/heart.json");
    EXPECT_EQ(found("surfaces/heart"), "shipped/surfaces/heart.json");
    EXPECT_EQ(found("surfaces/heart.json"), "shipped/surfaces/heart.json");
    EXPECT_EQ(found("default"), "shipped/default.json");
    EXPECT_EQ(found("mine"), "data/zeroset/presets/mine.json");
}

TEST_F(FindPreset, prefers_a_file_then_an_own_one) {
    add("data/zeroset/presets/heart.json");
    EXPECT_EQ(found("heart"), "data/zeroset/presets/heart.json");
    const std::string path = (folder_ / "shipped/notes.txt").string();
    EXPECT_EQ(scene::find_preset(path)->string(), path);
}

TEST_F(FindPreset, suggests_near_names) {
    EXPECT_EQ(found("hart"), "there is no preset 'hart'; did you mean 'heart'?");
    EXPECT_EQ(found("surface/heart"),
              "there is no preset 'surface/heart'; did you mean 'surfaces/heart'?");
    EXPECT_EQ(found("zzzzzz"),
              "there is no preset 'zzzzzz'; give the path of a .json file, or a name such as "
              "'barth_sextic'");
    const std::string near = (folder_ / "shipped/defautl.json").string();
    EXPECT_EQ(found(near), "there is no preset '" + near + "'; did you mean '" +
                               (folder_ / "shipped/default.json").string() + "'?");
}

TEST_F(FindPreset, tells_a_directory_from_a_preset) {
    const std::string path = (folder_ / "shipped").string();
    EXPECT_EQ(found(path), "'" + path + "' is a directory, not a preset; name a .json file in it");
    EXPECT_EQ(found(""), "a preset needs a name");
}

TEST_F(FindPreset, lists_what_is_below_a_folder_in_order) {
    EXPECT_EQ(scene::list_presets(folder_ / "shipped"),
              (std::vector<fs::path>{"default.json", "surfaces/heart.json"}));
    EXPECT_TRUE(scene::list_presets(folder_ / "no").empty());
    EXPECT_TRUE(scene::list_presets("").empty());
}

TEST_F(FindPreset, knows_the_folders) {
    EXPECT_EQ(scene::shipped_presets_folder(), folder_ / "shipped");
    EXPECT_EQ(scene::user_presets_folder(), folder_ / "data/zeroset/presets");
}

TEST(UserPresetsFolder, is_below_the_home_folder_by_default) {
    const Variable data("XDG_DATA_HOME", "");
    const Variable home("HOME", "/somewhere");
    EXPECT_EQ(scene::user_presets_folder(), "/somewhere/.local/share/zeroset/presets");
}

}  // namespace
