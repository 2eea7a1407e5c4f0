// SPDX-License-Identifier: MIT
// The examples and tables of docs/language.md, held against the program.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "field/primitives.h"
#include "formula/built_in.h"
#include "formula/combinations.h"
#include "formula/functions.h"
#include "formula/prelude.h"
#include "formula/understood.h"
#include "formula/vector_functions.h"

namespace formula {
namespace {

std::string document() {
    std::ifstream file(ZEROSET_SOURCE_DIR "/docs/language.md");
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The contents of the fenced blocks of one kind.
std::vector<std::string> blocks(const std::string& text, const std::string& kind) {
    std::vector<std::string> list;
    const std::string fence = "\n```" + kind + "\n";
    for (std::size_t at = text.find(fence); at != std::string::npos; at = text.find(fence, at)) {
        at += fence.size();
        const std::size_t end = text.find("\n```", at);
        list.push_back(text.substr(at, end - at));
        at = end;
    }
    return list;
}

TEST(LanguageDocument, all_examples_are_understood) {
    const std::vector<std::string> examples = blocks(document(), "zeroset");
    EXPECT_GE(examples.size(), 20u);
    for (const std::string& example : examples) EXPECT_EQ(report_of(example), "") << example;
}

TEST(LanguageDocument, all_reports_are_what_the_program_says) {
    const std::vector<std::string> reports = blocks(document(), "report");
    EXPECT_GE(reports.size(), 1u);
    for (const std::string& report : reports) {
        // The second line is the formula.
        const std::size_t first = report.find('\n') + 1;
        const std::string formula = report.substr(first, report.find('\n', first) - first);
        EXPECT_EQ(report_of(formula), report + "\n");
    }
}

TEST(LanguageDocument, lists_every_callable_with_its_signature) {
    const std::string text = document();
    const auto expect = [&](const std::string& call) {
        EXPECT_NE(text.find("| `" + call + "` |"), std::string::npos) << call;
    };
    for (const Function& it : functions()) {
        if (it.name != "hypot") expect(std::string(it.signature));
    }
    expect("hypot(a, b)");
    for (const VectorFunction& it : vector_functions()) expect(std::string(it.signature));
    for (const Combination& it : combinations()) expect(std::string(it.signature));
    for (const field::Primitive& it : field::primitives()) expect(signature(it));
    for (const std::string_view it : prelude_names()) expect(signature(it));
}

}  // namespace
}  // namespace formula
