// SPDX-License-Identifier: MIT
// Every preset's program is the same each time and is accepted by the reference compiler of GLSL,
// not only by the driver at hand.
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/file.h"
#include "compile/compile.h"
#include "scene/preset.h"

namespace {

namespace fs = std::filesystem;

const fs::path presets = fs::path(ZEROSET_SOURCE_DIR) / "presets";

scene::Document read(const std::string& name) {
    const auto text = base::read_text(presets / name, scene::largest_preset);
    EXPECT_TRUE(text) << name;
    auto preset = scene::read_preset(text ? *text : "");
    EXPECT_TRUE(preset) << name;
    return preset ? std::move(preset->document) : scene::Document{};
}

shader::ProgramSource program_of(const scene::Document& document, const shader::Outputs& outputs) {
    const auto formula = compile::compile_formula(document.formula);
    EXPECT_TRUE(formula);
    return formula ? compile::program_source(*formula, document, outputs) : shader::ProgramSource{};
}

std::vector<std::string> preset_names() {
    std::vector<std::string> names;
    for (const fs::path& path : scene::list_presets(presets))
        names.push_back(path.generic_string());
    return names;
}

class ProgramText : public testing::TestWithParam<std::string> {};

TEST_P(ProgramText, is_the_same_twice) {
    const scene::Document document = read(GetParam());
    const auto first = program_of(document, {});
    const auto second = program_of(document, {});
    EXPECT_FALSE(first.fragment.empty());
    EXPECT_EQ(first.vertex, second.vertex);
    EXPECT_EQ(first.fragment, second.fragment);
}

TEST_P(ProgramText, passes_the_reference_compiler) {
    const std::string validator = GLSLANG_VALIDATOR;
    ASSERT_TRUE(fs::exists(validator)) << "install glslang-tools";
    const fs::path folder = fs::path(ZEROSET_BINARY_DIR) / "golden-programs";
    fs::create_directories(folder);
    fs::path name = GetParam();
    std::string flat = name.replace_extension().generic_string();
    std::replace(flat.begin(), flat.end(), '/', '-');
    const shader::Outputs all{.picture = true, .geometry = true, .normal = true};
    const shader::ProgramSource source = program_of(read(GetParam()), all);
    const fs::path vertex = folder / (flat + ".vert");
    const fs::path fragment = folder / (flat + ".frag");
    ASSERT_TRUE(base::write_atomically(vertex, source.vertex));
    ASSERT_TRUE(base::write_atomically(fragment, source.fragment));
    const std::string log = (folder / (flat + ".log")).string();
    const std::string command = fmt::format("'{}' -l '{}' '{}' > '{}' 2>&1", validator,
                                            vertex.string(), fragment.string(), log);
    const int exit_status = std::system(command.c_str());
    const auto text = base::read_text(log, 1 << 20);
    EXPECT_EQ(exit_status, 0) << fragment << '\n' << (text ? *text : "");
}

TEST_P(ProgramText, passes_the_reference_compiler_with_every_tracer) {
    const fs::path folder = fs::path(ZEROSET_BINARY_DIR) / "golden-programs";
    fs::create_directories(folder);
    scene::Document document = read(GetParam());
    std::string flat = fs::path(GetParam()).replace_extension().generic_string();
    std::replace(flat.begin(), flat.end(), '/', '-');
    std::string files;
    for (const shader::TracerName& tracer : shader::tracers()) {
        document.settings.tracer = tracer.name;
        const fs::path file = folder / fmt::format("{}-{}.frag", flat, tracer.name);
        const shader::ProgramSource source = program_of(document, {});
        ASSERT_TRUE(base::write_atomically(file, source.fragment));
        files += fmt::format(" '{}'", file.string());
    }
    const std::string log = (folder / (flat + "-tracers.log")).string();
    const std::string command = fmt::format("'{}'{} > '{}' 2>&1", GLSLANG_VALIDATOR, files, log);
    const int exit_status = std::system(command.c_str());
    const auto text = base::read_text(log, 1 << 20);
    EXPECT_EQ(exit_status, 0) << (text ? *text : "");
}

std::string name_of(const testing::TestParamInfo<std::string>& info) {
    std::string name;
    for (const char c : info.param) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(Presets, ProgramText, testing::ValuesIn(preset_names()), name_of);

}  // namespace
