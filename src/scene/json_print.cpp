// SPDX-License-Identifier: MIT
// The spelling of JSON: one layout for one value, so that differences between files are small.
#include <algorithm>

#include <fmt/format.h>

#include "scene/json.h"
#include "scene/utf8.h"

namespace scene {
namespace {

using Kind = Json::Kind;

constexpr std::size_t widest_line = 100;

std::string quote(std::string_view text) {
    std::string out = "\"";
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = utf8_length(text, at);
        const char c = text[at];
        if (length == 0) {
            out += "\\ufffd";  // JSON cannot hold a broken character
        } else if (length > 1) {
            out += text.substr(at, length);
        } else if (c == '"' || c == '\\') {
            out += {'\\', c};
        } else if (c == '\n') {
            out += "\\n";
        } else if (c == '\t') {
            out += "\\t";
        } else if (c == '\r') {
            out += "\\r";
        } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
            out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        } else {
            out += c;
        }
        at += std::max<std::size_t>(length, 1);
    }
    return out + '"';
}

bool is_scalar(const Json& json) { return json.kind != Kind::list && json.kind != Kind::object; }

bool is_short(const Json& json) {
    switch (json.kind) {
        case Kind::list:
            return std::all_of(json.elements.begin(), json.elements.end(),
                               [](const Json& e) { return is_scalar(e) && e.kind != Kind::text; });
        case Kind::object:
            return json.members.empty() ||
                   (json.members.size() == 1 && json.members[0].value.kind != Kind::object &&
                    is_short(json.members[0].value));
        case Kind::null:
        case Kind::boolean:
        case Kind::number:
        case Kind::text:
            break;
    }
    return true;
}

void print(const Json& json, std::size_t indentation, std::string& out);

/// `[` or `{`, one entry a line, and the closing bracket.
template <class Entries, class PrintEntry>
void print_lines(const Entries& entries, char open, char close, std::size_t indentation,
                 std::string& out, PrintEntry print_entry) {
    const std::size_t inner = indentation + 2;
    out += open;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        out += i == 0 ? "\n" : ",\n";
        out.append(inner, ' ');
        print_entry(entries[i], inner);
    }
    out += '\n';
    out.append(indentation, ' ');
    out += close;
}

void print(const Json& json, std::size_t indentation, std::string& out) {
    if (is_scalar(json) || is_short(json)) {
        const std::string line = print_json_compact(json);
        if (is_scalar(json) || indentation + line.size() <= widest_line) {
            out += line;
            return;
        }
    }
    if (json.kind == Kind::list) {
        print_lines(json.elements, '[', ']', indentation, out,
                    [&](const Json& e, std::size_t inner) { print(e, inner, out); });
    } else {
        print_lines(json.members, '{', '}', indentation, out,
                    [&](const JsonMember& m, std::size_t inner) {
                        out += quote(m.key) + ": ";
                        print(m.value, inner, out);
                    });
    }
}

}  // namespace

std::string print_json(const Json& json) {
    std::string out;
    print(json, 0, out);
    return out;
}

std::string print_json_compact(const Json& json) {
    std::string out;
    switch (json.kind) {
        case Kind::null:
            return "null";
        case Kind::boolean:
            return json.truth ? "true" : "false";
        case Kind::number:
            return json.text;
        case Kind::text:
            return quote(json.text);
        case Kind::list:
            for (const Json& e : json.elements) {
                out += (out.empty() ? "" : ", ") + print_json_compact(e);
            }
            return fmt::format("[{}]", out);
        case Kind::object:
            for (const JsonMember& m : json.members) {
                out += (out.empty() ? "" : ", ") + quote(m.key) + ": ";
                out += print_json_compact(m.value);
            }
            return fmt::format("{{{}}}", out);
    }
    return out;
}

}  // namespace scene
