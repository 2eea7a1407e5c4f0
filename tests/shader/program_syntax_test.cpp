// SPDX-License-Identifier: MIT
// Every program is GLSL by the reference compiler, whatever is switched on.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <vector>

#include "base/temporary_folder.h"
#include "field/primitives.h"
#include "formula/prelude.h"
#include "shader/programs.h"

namespace shader {
namespace {

struct Finished {
    int status = -1;
    std::string output;
};

Finished run(const std::string& command) {
    Finished finished;
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    if (!pipe) return finished;
    char buffer[4096];
    while (const std::size_t size = std::fread(buffer, 1, sizeof buffer, pipe)) {
        finished.output.append(buffer, size);
    }
    const int status = pclose(pipe);
    finished.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return finished;
}

std::vector<Features> all_features() {
    constexpr Outputs outputs[] = {{true, false, false, false},
                                   {false, true, true, true, false, true},
                                   {true, true, true, false}};
    std::vector<Features> list;
    for (const TracerName& tracer : tracers()) {
        for (int bounds = 0; bounds < 3; ++bounds) {
            for (const Outputs& output : outputs) {
                for (int switches = 0; switches < 4; ++switches) {
                    Features features;
                    features.tracer = tracer.name;
                    features.bounds_sphere = bounds == 0;
                    features.bounds_box = bounds == 1;
                    features.shadows = (switches & 1) == 0;
                    features.grid = (switches & 1) != 0;
                    features.show_steps = (switches & 2) != 0;
                    features.outputs = output;
                    list.push_back(features);
                }
            }
        }
        Features measured;
        measured.tracer = tracer.name;
        measured.show_normals = true;
        list.push_back(measured);
        measured.show_normals = false;
        measured.show_certificate = true;
        list.push_back(measured);
        measured = {};
        measured.tracer = tracer.name;
        measured.whole_tiles = true;
        measured.outputs = {true, true, true, true};
        list.push_back(measured);
        measured = {};
        measured.tracer = tracer.name;
        measured.told_depth = true;
        measured.outputs = {true, true, true, true};
        list.push_back(measured);
    }
    return list;
}

/// Programs, each in a file of its own, to be compiled all at once.
class Programs {
public:
    void add(const field::Field& field, const Features& features) {
        const ProgramSource source = program_source(field, features);
        for (const std::string& text : {source.fragment, source.prepass}) {
            if (text.empty()) continue;
            const std::string name = std::to_string(count_++) + ".frag";
            std::ofstream(folder_ / name) << text;
        }
    }
    void expect_valid() const {
        ASSERT_EQ(run("command -v glslangValidator").status, 0)
            << "cannot find the program glslangValidator; install the package glslang-tools";
        const Finished finished =
            run("cd '" + folder_.path().string() + "' && glslangValidator -S frag *.frag");
        EXPECT_EQ(finished.status, 0);
        EXPECT_FALSE(has(finished.output, "ERROR")) << finished.output;
        EXPECT_FALSE(has(finished.output, "WARNING")) << finished.output;
    }

private:
    TemporaryFolder folder_;
    int count_ = 0;
};

TEST(ProgramSyntax, is_valid_for_every_formula_with_everything_on) {
    Programs programs;
    Features features;
    features.grid = true;
    features.outputs = {true, true, true, true};
    for (const char* text : formulas) programs.add(field_of(text), features);
    programs.expect_valid();
}

TEST(ProgramSyntax, is_valid_for_every_formula_with_every_tracer) {
    Programs programs;
    Features features;
    features.outputs = {true, true, true, true};
    for (const TracerName& tracer : tracers()) {
        features.tracer = tracer.name;
        for (const char* text : formulas) programs.add(field_of(text), features);
    }
    programs.expect_valid();
}

TEST(ProgramSyntax, is_valid_in_double_precision_for_every_formula_with_every_tracer) {
    Programs programs;
    Features features;
    features.precision = Precision::doubled;
    features.outputs = {true, true, true, true};
    for (const TracerName& tracer : tracers()) {
        features.tracer = tracer.name;
        for (const char* text : formulas) programs.add(field_of(text), features);
    }
    programs.expect_valid();
}

TEST(ProgramSyntax, is_valid_about_another_origin) {
    Programs programs;
    Features features;
    features.precision = Precision::recentred;
    for (const char* text : formulas) {
        const field::Field field = field_of(text);
        const bool cells = std::ranges::any_of(field.nodes, [](const field::Node& node) {
            return std::holds_alternative<field::Cells>(node);
        });
        if (!cells) programs.add(field, features);
    }
    programs.expect_valid();
}

TEST(ProgramSyntax, is_valid_for_all_features) {
    for (const char* text : {formulas[0], formulas[8], formulas[12]}) {
        Programs programs;
        const field::Field field = field_of(text);
        for (Features features : all_features()) {
            programs.add(field, features);
            if (features.tracer != "auto") continue;
            features.precision = Precision::doubled;
            programs.add(field, features);
        }
        programs.expect_valid();
    }
}

TEST(ProgramSyntax, is_valid_for_every_built_in_field) {
    Programs programs;
    for (const std::string_view name : formula::prelude_names()) {
        programs.add(field_of(std::string(name) + "()"), {});
    }
    for (const field::Primitive& primitive : field::primitives()) {
        std::string arguments;
        for (const field::Argument& argument : primitive.arguments) {
            if (!argument.required) continue;
            arguments += arguments.empty() ? "1" : ", 1";
        }
        const std::string text = std::string(primitive.name) + "(" + arguments + ")";
        programs.add(field_of(text), {});
    }
    programs.expect_valid();
}

}  // namespace
}  // namespace shader
