// SPDX-License-Identifier: MIT
// Joins a driver's log with the source lines it speaks of.
#include "render/shader_log.h"

#include <charconv>
#include <optional>
#include <vector>

#include <fmt/format.h>

namespace render {

namespace {

std::vector<std::string_view> split_lines(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        lines.push_back(text.substr(0, end));
        text.remove_prefix(end == text.npos ? text.size() : end + 1);
    }
    return lines;
}

// The line number of source string 0, counted from 1, if the message names one.
std::optional<std::size_t> line_number(std::string_view message) {
    for (std::string_view prefix : {"ERROR: ", "WARNING: "})
        if (message.starts_with(prefix)) message.remove_prefix(prefix.size());
    if (!message.starts_with("0:") && !message.starts_with("0(")) return std::nullopt;
    message.remove_prefix(2);
    std::size_t number = 0;
    const auto [end, problem] =
        std::from_chars(message.data(), message.data() + message.size(), number);
    if (problem != std::errc{} || number == 0) return std::nullopt;
    return number;
}

}  // namespace

std::string annotate(std::string_view log, std::string_view source, int most_lines) {
    const std::vector<std::string_view> source_lines = split_lines(source);
    std::string text;
    int kept = 0;
    for (std::string_view message : split_lines(log)) {
        while (!message.empty() && (message.back() == '\0' || message.back() == '\r'))
            message.remove_suffix(1);
        if (message.empty()) continue;
        if (kept++ == most_lines) return text + "\n...";
        text += fmt::format("{}{}", text.empty() ? "" : "\n", message);
        const auto line = line_number(message);
        if (line && *line <= source_lines.size())
            text += fmt::format("\n{:>6} | {}", *line, source_lines[*line - 1]);
    }
    return text;
}

}  // namespace render
