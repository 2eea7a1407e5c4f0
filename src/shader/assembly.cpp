// SPDX-License-Identifier: MIT
#include "shader/assembly.h"

#include <cassert>

#include "shader/parts.h"

namespace shader {
namespace {

constexpr std::string_view include_mark = "#include \"";

std::string_view without_comment(std::string_view line) {
    line = line.substr(0, line.find("//"));
    while (!line.empty() && line.back() == ' ') line.remove_suffix(1);
    return line;
}

/// The part for double precision, if it has one of its own.
std::string in_double(std::string_view path) {
    const std::size_t name = path.rfind('/') + 1;
    std::string own = std::string(path.substr(0, name)) + "double/";
    own += path.substr(name);
    return parts().contains(own) ? own : std::string(path);
}

}  // namespace

void Assembly::add_part(std::string_view path) {
    if (!added_.emplace(path).second) return;
    const auto found =
        parts().find(precision_ == Precision::doubled ? in_double(path) : std::string(path));
    assert(found != parts().end());
    std::string_view rest = found->second;
    std::string code;
    while (!rest.empty()) {
        const std::size_t end = rest.find('\n');
        const std::string_view line = without_comment(rest.substr(0, end));
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
        if (line.starts_with(include_mark)) {
            const std::string_view name = line.substr(include_mark.size());
            add_part(name.substr(0, name.find('"')));
        } else if (!line.empty()) {
            code.append(line).push_back('\n');
        }
    }
    text_ += code;
}

}  // namespace shader
