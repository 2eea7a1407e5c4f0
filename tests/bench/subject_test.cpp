// SPDX-License-Identifier: MIT
#include "bench/subject.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "base/temporary_folder.h"
#include "bench/generated.h"

namespace bench {
namespace {

class SubjectTest : public testing::Test {
protected:
    void SetUp() override { setenv("ZEROSET_PRESETS", ZEROSET_SOURCE_DIR "/presets", 1); }

    std::string write(const std::string& name, const std::string& text) {
        const auto path = folder.path() / name;
        std::ofstream(path) << text;
        return path.string();
    }
    static std::vector<std::string> names(const std::vector<std::string>& wanted) {
        std::vector<std::string> list;
        const auto files = find_subjects(wanted);
        if (!files) return {files.problems()[0].message};
        for (const NamedFile& file : *files) list.push_back(file.name);
        return list;
    }
    static bool smooth(const std::string& name) {
        const auto files = find_subjects({name});
        if (!files) return false;
        const auto subject = read_subject((*files)[0].path, name, 1);
        EXPECT_TRUE(subject);
        return subject && subject->smooth;
    }

    TemporaryFolder folder;
};

TEST_F(SubjectTest, names_are_presets_and_folders_of_them) {
    EXPECT_EQ(names({"heart", "fractals/mandelbulb", "heart"}),
              (std::vector<std::string>{"surfaces/heart", "fractals/mandelbulb"}));
    const auto periodic = names({"periodic"});
    EXPECT_GE(periodic.size(), 6U);
    EXPECT_EQ(periodic[0], "periodic/diamond_labyrinth");
    EXPECT_GE(names({}).size(), 50U);
    write("one.json", "{}");
    EXPECT_EQ(names({folder.path().string()}),
              std::vector<std::string>{(folder.path() / "one").generic_string()});
}

TEST_F(SubjectTest, an_unknown_name_is_an_error) {
    EXPECT_NE(names({"haert"})[0].find("heart"), std::string::npos);
    EXPECT_EQ(names({folder.path().string()})[0], "there is no preset to measure; name one");
}

TEST_F(SubjectTest, a_bad_preset_is_an_error_that_names_the_file) {
    for (const char* formula : {"sine(x) = 0", "x = 0 ="}) {
        const std::string path =
            write("bad.json", std::string(R"({"zeroset": 1, "formula": ")") + formula + "\"}");
        const auto subject = read_subject(path, "bad", 1);
        ASSERT_FALSE(subject);
        EXPECT_TRUE(subject.problems()[0].message.starts_with(path + ": "));
    }
    EXPECT_FALSE(read_subject(write("worse.json", "{"), "worse", 1));
    EXPECT_FALSE(read_subject(write("wrong.json", R"({"zeroset": 1, "formula": ["param a = 1",
                 "x = a"], "parameters": {"a": "high"}})"),
                              "wrong", 1));
}

TEST_F(SubjectTest, has_scenes_of_many_primitives) {
    for (const auto& [name, count] : {std::pair{few_name, 10U}, {many_name, 1000U}}) {
        EXPECT_EQ(names({std::string(name)}), std::vector{std::string(name)});
        const auto subject = read_subject(name, std::string(name), 1);
        ASSERT_TRUE(subject) << subject.problems()[0].message;
        const std::string& text = subject->document.formula;
        std::size_t balls = 0;
        for (std::size_t at = text.find("ball("); at != std::string::npos;
             at = text.find("ball(", at + 1)) {
            ++balls;
        }
        EXPECT_EQ(balls, count + 1);  // and the definition
    }
}

TEST_F(SubjectTest, knows_what_is_proven_to_be_smooth) {
    EXPECT_TRUE(smooth("surfaces/heart"));
    EXPECT_TRUE(smooth("periodic/gyroid"));
    EXPECT_FALSE(smooth("fractals/mandelbulb"));
    EXPECT_FALSE(smooth("periodic/schwarz_d"));  // abs
}

}  // namespace
}  // namespace bench
