// SPDX-License-Identifier: MIT
// Opening, saving, and the names that users type.
#include "studio/document_file.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

/// A private home folder.
class DocumentFile : public testing::Test {
protected:
    void SetUp() override {
        home_ = fs::path(testing::TempDir()) / ("studio-" + std::to_string(getpid()));
        fs::remove_all(home_);
        fs::create_directories(home_);
        setenv("HOME", home_.c_str(), 1);
        setenv("XDG_DATA_HOME", (home_ / "data").c_str(), 1);
        setenv("ZEROSET_PRESETS", (home_ / "shipped").c_str(), 1);
    }
    void TearDown() override { fs::remove_all(home_); }

    fs::path home_;
};

TEST_F(DocumentFile, names_without_a_path_go_to_the_user_s_presets) {
    const fs::path presets = home_ / "data" / "zeroset" / "presets";
    EXPECT_EQ(*studio::preset_path("egg"), presets / "egg.json");
    EXPECT_EQ(*studio::preset_path("  my eggs/blue egg  "), presets / "my eggs" / "blue egg.json");
    EXPECT_EQ(*studio::preset_path("egg.json"), presets / "egg.json");
    EXPECT_EQ(*studio::preset_path("version 1.5"), presets / "version 1.5.json");
}

TEST_F(DocumentFile, paths_stand_as_they_are) {
    EXPECT_EQ(*studio::preset_path("/somewhere/egg.json"), "/somewhere/egg.json");
    EXPECT_EQ(*studio::preset_path("~/egg"), home_ / "egg.json");
    EXPECT_EQ(*studio::preset_path("./egg"), fs::current_path() / "egg.json");
}

TEST_F(DocumentFile, empty_names_and_folders_are_refused) {
    ASSERT_FALSE(studio::preset_path("   "));
    EXPECT_EQ(studio::preset_path("   ").problems()[0].message, "the name is empty; type one");
    ASSERT_FALSE(studio::preset_path("eggs/"));
    EXPECT_EQ(studio::preset_path("eggs/").problems()[0].message,
              "this is a folder; add a name for the file");
}

TEST_F(DocumentFile, pictures_get_names_that_are_not_taken) {
    const fs::path first = studio::fresh_picture_path("A: blue/egg?");
    EXPECT_EQ(first.filename(), "A-blue-egg-1.png");
    fs::create_directories(first.parent_path());
    std::ofstream(first) << "taken";
    EXPECT_EQ(studio::fresh_picture_path("A: blue/egg?").filename(), "A-blue-egg-2.png");
    fs::create_directories(home_ / "Pictures");
    EXPECT_EQ(studio::pictures_folder(), home_ / "Pictures" / "zeroset");
}

TEST_F(DocumentFile, saves_and_opens_the_same_document) {
    studio::Workspace workspace(studio::first_document());
    workspace.document.title = "Egg";
    workspace.document.settings.shadow = 3;
    EXPECT_TRUE(workspace.unsaved());
    const fs::path file = *studio::preset_path("new folder/egg");
    ASSERT_TRUE(studio::save_file(workspace, file));
    EXPECT_FALSE(workspace.unsaved());
    EXPECT_EQ(workspace.file, file);
    EXPECT_FALSE(workspace.shipped);
    ASSERT_EQ(workspace.presets.own.size(), 1u);
    EXPECT_EQ(workspace.presets.own[0].title, "Egg");
    EXPECT_EQ(workspace.presets.own[0].folder, "new folder");

    studio::Workspace other(scene::Document{});
    ASSERT_TRUE(studio::open_file(other, file));
    EXPECT_EQ(other.document, workspace.document);
    EXPECT_FALSE(other.unsaved());
    EXPECT_FALSE(other.history.can_undo());
}

TEST_F(DocumentFile, drops_values_that_an_understood_formula_has_no_use_for) {
    studio::Workspace workspace(studio::first_document());
    workspace.document.parameters = {{"a", 2.0}, {"gone", 1.0}, {"b", true}};
    const fs::path file = *studio::preset_path("egg");
    // While nothing is known about the formula, nothing is dropped.
    ASSERT_TRUE(studio::save_file(workspace, file));
    EXPECT_EQ(workspace.document.parameters.size(), 3u);
    workspace.compilation.text = workspace.document.formula;
    field::Parameter parameter;
    parameter.name = "a";
    parameter.initial = {1};
    workspace.compilation.parameters = {parameter, parameter};
    workspace.compilation.parameters[1].name = "b";
    ASSERT_TRUE(studio::save_file(workspace, file));
    EXPECT_EQ(workspace.document.parameters, (scene::ParameterValues{{"a", 2.0}}));
    EXPECT_FALSE(workspace.unsaved());
}

TEST_F(DocumentFile, a_broken_file_changes_nothing_and_says_where) {
    fs::create_directories(home_ / "shipped");
    const fs::path file = home_ / "shipped" / "broken.json";
    std::ofstream(file) << "{\n  \"zeroset\": 1,\n  \"formula\": 7\n}\n";
    studio::Workspace workspace(studio::first_document());
    const auto status = studio::open_file(workspace, file);
    ASSERT_FALSE(status);
    EXPECT_EQ(status.problems()[0].message.rfind(file.string() + ":3:", 0), 0u)
        << status.problems()[0].message;
    EXPECT_EQ(workspace.document, studio::first_document());
    EXPECT_FALSE(workspace.file);
}

TEST_F(DocumentFile, knows_shipped_presets) {
    fs::create_directories(home_ / "shipped" / "eggs");
    const fs::path file = home_ / "shipped" / "eggs" / "egg.json";
    std::ofstream(file) << "{\"zeroset\": 1, \"formula\": \"x = 0\"}\n";
    studio::Workspace workspace(studio::first_document());
    ASSERT_TRUE(studio::open_file(workspace, file));
    EXPECT_TRUE(workspace.shipped);
    EXPECT_EQ(workspace.name(), "egg");
}

}  // namespace
