// SPDX-License-Identifier: MIT
#include "formula/prelude.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <mutex>
#include <optional>

#include "formula/lowering.h"
#include "formula/parse.h"
#include "formula/prelude_texts.h"

namespace formula {
namespace {

constexpr std::string_view extension = ".zeroset";

/// One text and what it is parsed to. Never moved: the function points into the program.
struct Entry {
    std::string text;
    std::once_flag once;
    Program program;
    std::optional<Source> source;
    FunctionValue function;

    void parse_once() {
        std::call_once(once, [this] {
            // Every program ends in an expression; nobody looks at this one.
            text += "\n0\n";
            base::Result<Program> parsed = parse(text);
            assert(parsed && parsed->statements.size() == 1);
            program = *std::move(parsed);
            source.emplace(Source{program, text, true});
            const auto& definition = std::get<Definition>(program.statements[0]);
            function = {definition.name, &definition, &*source, nullptr, 0};
        });
    }
};

std::map<std::string, Entry, std::less<>>& entries() {
    static auto table = [] {
        std::map<std::string, Entry, std::less<>> list;
        for (const auto& [file, text] : prelude_texts()) {
            list[file.substr(0, file.size() - extension.size())].text = text;
        }
        return list;
    }();
    return table;
}

}  // namespace

const std::vector<std::string_view>& prelude_names() {
    static const auto names = [] {
        std::vector<std::string_view> list;
        for (const auto& [name, entry] : entries()) list.push_back(name);
        return list;
    }();
    return names;
}

bool is_in_prelude(std::string_view name) { return entries().contains(name); }

const FunctionValue& prelude_function(std::string_view name) {
    Entry& entry = entries().find(name)->second;
    entry.parse_once();
    return entry.function;
}

std::string prelude_summary(std::string_view name) {
    const auto found = prelude_texts().find(std::string(name) + std::string(extension));
    assert(found != prelude_texts().end());
    std::string_view text = found->second;
    std::string summary;
    while (text.starts_with('#')) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        if (!summary.empty()) summary += ' ';
        summary += line.substr(std::min<std::size_t>(line.find_first_not_of("# "), line.size()));
    }
    return summary;
}

}  // namespace formula
