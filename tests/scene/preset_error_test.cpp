// SPDX-License-Identifier: MIT
// What is said about presets that cannot be read, and where.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene/preset.h"

namespace {

/// "MARKED BYTES|MESSAGE" for each problem of a text.
std::vector<std::string> problems(const std::string& text) {
    const auto preset = scene::read_preset(text);
    std::vector<std::string> out;
    for (const base::Diagnostic& problem : preset.problems()) {
        EXPECT_EQ(problem.severity, base::Severity::error);
        const base::SourceSpan span = problem.span.value();
        out.push_back(
            fmt::format("{}|{}", text.substr(span.begin, span.end - span.begin), problem.message));
    }
    return out;
}

/// The only problem of a preset with one more field.
std::string problem_with(const std::string& field) {
    const auto all = problems(R"({"zeroset": 1, "formula": "x", )" + field + "}");
    EXPECT_EQ(all.size(), 1u) << field;
    return all.empty() ? "no problem" : all[0];
}

using Problems = std::vector<std::string>;

TEST(PresetErrors, are_all_reported_in_the_order_of_their_places) {
    EXPECT_EQ(problems(R"({"settings": {"steps": "many", "epsilon": 0}, "zeroset": 1,
                          "title": 5, "camera": {"eye": [1, 2, "3"]}})"),
              (Problems{
                  "{|the formula is missing; add a field 'formula', such as "
                  "\"formula\": \"x^2 + y^2 + z^2 = 1\"",
                  "\"many\"|'settings.steps' must be a whole number from 1 to 100000, not \"many\"",
                  "0|'settings.epsilon' must be a number from 1e-06 to 100, not 0",
                  "5|'title' must be text in quotes, not 5",
                  "{\"eye\": [1, 2, \"3\"]}|'camera' needs the field 'target'",
                  "\"3\"|'camera.eye[2]' must be a number from -1000000 to 1000000, not \"3\"",
              }));
}

TEST(PresetErrors, have_the_place_in_the_file) {
    const std::string text =
        "{\n  \"zeroset\": 1,\n  \"formula\": \"x\",\n  \"time\": \"now\"\n}\n";
    EXPECT_EQ(base::format(scene::read_preset(text).problems().at(0), "a.json", text),
              "a.json:4:11: error: 'time' must be a number, not \"now\"\n"
              "  \"time\": \"now\"\n"
              "          ^~~~~\n");
}

TEST(PresetErrors, tell_what_is_no_preset) {
    EXPECT_EQ(problems("[1]"),
              Problems{"[1]|this is not a Zeroset preset: it must begin with '{'"});
    EXPECT_EQ(problems("5"), Problems{"5|this is not a Zeroset preset: it must begin with '{'"});
    EXPECT_EQ(problems(R"({"formula": "x"})"),
              Problems{"{|this is not a Zeroset preset: the field 'zeroset' with its version is "
                       "missing; add \"zeroset\": 1"});
    EXPECT_EQ(problems(""), Problems{"|the file is empty"});
    EXPECT_EQ(problems(R"({"zeroset": 1, "formula": "x)"),
              Problems{"|the file ends in the middle of the preset; it may have been cut off"});
}

TEST(PresetErrors, tell_which_versions_are_read) {
    const auto version = [](const std::string& number) {
        return problems("{\"zeroset\": " + number + ", \"shape\": 1}").at(0);
    };
    EXPECT_EQ(version("7"),
              "7|this preset was written by a newer Zeroset (version 7); this one reads "
              "up to 1");
    for (const char* wrong : {"0", "-1", "1.5", "\"1\"", "null"}) {
        EXPECT_EQ(
            version(wrong),
            fmt::format("{0}|'zeroset' must be the version of the preset, a whole number from "
                        "1 to 1, not {0}",
                        wrong));
    }
}

TEST(PresetErrors, ask_for_a_formula) {
    const std::string empty = "the formula is empty; write one, such as \"x^2 + y^2 + z^2 = 1\"";
    EXPECT_EQ(problems(R"({"zeroset": 1, "formula": ""})"), Problems{"\"\"|" + empty});
    EXPECT_EQ(problems(R"({"zeroset": 1, "formula": " \n\t"})"), Problems{"\" \\n\\t\"|" + empty});
    EXPECT_EQ(problems(R"({"zeroset": 1, "formula": []})"), Problems{"[]|" + empty});
    EXPECT_EQ(problems(R"({"zeroset": 1, "formula": 5})"),
              Problems{"5|'formula' must be text in quotes or a list of lines, not 5"});
    EXPECT_EQ(problems(R"({"zeroset": 1, "formula": ["x", 5, {}]})"),
              (Problems{"5|'formula[1]' must be text in quotes, not 5",
                        "{}|'formula[2]' must be text in quotes, not an object"}));
}

TEST(PresetErrors, tell_the_type_that_is_wanted) {
    EXPECT_EQ(problem_with(R"("settings": {"shadows": 1})"),
              "1|'settings.shadows' must be true or false, not 1");
    EXPECT_EQ(problem_with(R"("settings": {"steps": 1.5})"),
              "1.5|'settings.steps' must be a whole number from 1 to 100000, not 1.5");
    EXPECT_EQ(problem_with(R"("settings": [])"),
              "[]|'settings' must be an object, not an empty list");
    EXPECT_EQ(problem_with(R"("description": null)"),
              "null|'description' must be text in quotes, not null");
    const std::string parameter =
        "a number, a list of 2 to 4 numbers, text in quotes, true or false, not ";
    EXPECT_EQ(problem_with(R"("parameters": {"a": null})"),
              "null|'parameters.a' must be " + parameter + "null");
    EXPECT_EQ(problem_with(R"("parameters": {"a": {}})"),
              "{}|'parameters.a' must be " + parameter + "an object");
    EXPECT_EQ(problem_with(R"("parameters": {"a": [1]})"),
              "[1]|'parameters.a' must be " + parameter + "a list of 1");
    EXPECT_EQ(problem_with(R"("parameters": {"a": [1, 2, 3, 4, 5]})"),
              "[1, 2, 3, 4, 5]|'parameters.a' must be " + parameter + "a list of 5");
    EXPECT_EQ(problem_with(R"("parameters": {"a": [1, "x"]})"),
              "\"x\"|'parameters.a[1]' must be a number, not \"x\"");
    EXPECT_EQ(problem_with(R"("parameters": 1)"), "1|'parameters' must be an object, not 1");
    EXPECT_EQ(problem_with(R"("title": ["a", "b"])"),
              "[\"a\", \"b\"]|'title' must be text in quotes, not a list of 2");
    EXPECT_EQ(problem_with(R"("time": "a very long text that nobody wants to read again")"),
              "\"a very long text that nobody wants to read again\"|'time' must be a number, not "
              "\"a very long text that nobody w...\"");
}

TEST(PresetErrors, tell_the_range_of_numbers) {
    EXPECT_EQ(problem_with(R"("settings": {"steps": 100001})"),
              "100001|'settings.steps' must be a whole number from 1 to 100000, not 100001");
    EXPECT_EQ(problem_with(R"("settings": {"lipschitz": 0})"),
              "0|'settings.lipschitz' must be a number from 0.001 to 1000, not 0");
    EXPECT_EQ(problem_with(R"("materials": [{"colour": [1, -1, 0]}])"),
              "-1|'materials[0].colour[1]' must be a number from 0 to 100, not -1");
    EXPECT_EQ(problem_with(R"("lights": [{}, {"intensity": -1}])"),
              "-1|'lights[1].intensity' must be a number from 0 to 100, not -1");
    EXPECT_EQ(problem_with(R"("environment": {"sky": [1, 1]})"),
              "[1, 1]|'environment.sky' must be a list of 3 numbers, not a list of 2");
}

TEST(PresetErrors, tell_about_numbers_that_are_not_finite) {
    EXPECT_EQ(problem_with(R"("time": NaN)"), "NaN|NaN is not a number; write a finite one");
    EXPECT_EQ(problem_with(R"("time": -Infinity)"),
              "-Infinity|-Infinity is not a number; write a finite one");
    EXPECT_EQ(problem_with(R"("time": 1e400)"), "1e400|the number 1e400 is too large");
}

TEST(PresetErrors, tell_about_useless_cameras) {
    EXPECT_EQ(problem_with(R"("camera": {"eye": [1, 2, 3], "target": [1, 2, 3]})"),
              "[1, 2, 3]|'camera.eye' and 'camera.target' must be two points apart");
    EXPECT_EQ(problem_with(R"("camera": {"eye": [1, 2, 3], "target": [0, 0, 0], "up": [0, 0, 0]})"),
              "[0, 0, 0]|'camera.up' must be a direction, not [0, 0, 0]");
    EXPECT_EQ(problem_with(R"("camera": {"eye": [1, 2, 3], "target": [0, 0, 0], "fov": 180})"),
              "180|'camera.fov' must be a number from 0.1 to 175, not 180");
    EXPECT_EQ(problem_with(R"("camera": {"target": [0, 0, 0]})"),
              "{\"target\": [0, 0, 0]}|'camera' needs the field 'eye'");
}

TEST(PresetErrors, tell_about_lists_of_the_wrong_length) {
    EXPECT_EQ(problem_with(R"("materials": [])"),
              "[]|'materials' must be a list of 1 to 16 objects, not an empty list");
    EXPECT_EQ(problem_with(R"("lights": [{},{},{},{},{},{},{},{},{}])"),
              "[{},{},{},{},{},{},{},{},{}]|'lights' must be a list of 0 to 8 objects, not a list "
              "of 9");
    EXPECT_EQ(problem_with(R"("lights": [5])"), "5|'lights[0]' must be an object, not 5");
    EXPECT_EQ(problem_with(R"("lights": [{"direction": [0, 0, 0]}])"),
              "[0, 0, 0]|'lights[0].direction' must be a direction, not [0, 0, 0]");
}

TEST(PresetErrors, tell_about_useless_bounds) {
    const std::string forms = "must be {\"sphere\": ...}, {\"box\": ...} or \"none\", not ";
    EXPECT_EQ(problem_with(R"("bounds": 3)"), "3|'bounds' " + forms + "3");
    EXPECT_EQ(problem_with(R"("bounds": "all")"), "\"all\"|'bounds' " + forms + "\"all\"");
    EXPECT_EQ(problem_with(R"("bounds": {"ball": 3})"),
              "{\"ball\": 3}|'bounds' " + forms + "an object");
    EXPECT_EQ(problem_with(R"("bounds": {"sphere": 0})"),
              "0|'bounds.sphere' must be a number from 1e-06 to 1000000, not 0");
    EXPECT_EQ(
        problem_with(R"("bounds": {"sphere": [1, 2]})"),
        "[1, 2]|'bounds.sphere' must be a radius or a list [x, y, z, radius], not a list of 2");
    EXPECT_EQ(problem_with(R"("bounds": {"sphere": [-1, -2, -3, -4]})"),
              "-4|'bounds.sphere[3]' must be a number from 1e-06 to 1000000, not -4");
    EXPECT_EQ(problem_with(R"("bounds": {"box": 1})"),
              "1|'bounds.box' must be a list [hx, hy, hz] of half extents or "
              "[x, y, z, hx, hy, hz], not 1");
    EXPECT_EQ(problem_with(R"("bounds": {"box": [1, 1, 0]})"),
              "0|'bounds.box[2]' must be a number from 1e-06 to 1000000, not 0");
    EXPECT_EQ(
        problem_with(R"("bounds": {"sphere": 1, "box": [1, 1, 1]})"),
        "{\"sphere\": 1, \"box\": [1, 1, 1]}|'bounds' has both 'sphere' and 'box'; keep one of "
        "them");
}

TEST(PresetErrors, tell_about_fields_that_stand_twice) {
    EXPECT_EQ(problem_with(R"("time": 1, "time": 2)"),
              "\"time\"|the field 'time' stands here a second time; keep one of them");
    EXPECT_EQ(problem_with(R"("settings": {"steps": 1, "steps": 1})"),
              "\"steps\"|the field 'settings.steps' stands here a second time; keep one of them");
    EXPECT_EQ(problem_with(R"("parameters": {"a": 1, "a": 1})"),
              "\"a\"|the field 'parameters.a' stands here a second time; keep one of them");
    EXPECT_EQ(problem_with(R"("sparkle": 1, "sparkle": 2)"),
              "\"sparkle\"|the field 'sparkle' stands here a second time; keep one of them");
}

TEST(PresetErrors, tell_about_broken_characters) {
    EXPECT_EQ(problem_with("\"title\": \"a\xFF\""),
              "\xFF|the file is not UTF-8 text; save it in that encoding");
}

}  // namespace
