// SPDX-License-Identifier: MIT
// JSON values that know their place in the text and keep the order of their members.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"

namespace scene {

struct JsonMember;

/// A JSON value. Only what belongs to its kind is filled.
struct Json {
    enum class Kind { null, boolean, number, text, list, object };
    Kind kind = Kind::null;
    bool truth = false;
    double number = 0;
    std::string text;  ///< a decoded text, or a number as it is spelt
    std::vector<Json> elements;
    std::vector<JsonMember> members;
    base::SourceSpan span;  ///< with quotes or brackets

    static Json of(bool truth);
    static Json of(double number);  ///< finite
    static Json of(std::string text);
    static Json of(std::vector<Json> elements);
    static Json object();

    /// The member of this name, or null.
    Json* find(std::string_view key);
    const Json* find(std::string_view key) const;
    void add(std::string key, Json value);
};

struct JsonMember {
    std::string key;
    base::SourceSpan key_span;
    Json value;
};

/// Reads one JSON text in UTF-8. Only the first error of the syntax is reported, in plain words.
base::Result<Json> parse_json(std::string_view text);

/// Several lines with two spaces of indentation; lists of numbers and objects of one short member
/// stay on one line. No newline at the end.
std::string print_json(const Json& json);
/// One line.
std::string print_json_compact(const Json& json);

/// For each byte of the decoded text that stands between quotes at `span`, and for its end, the
/// byte of `source` that it comes from. `source` must be a well-formed JSON text there.
std::vector<std::uint32_t> text_places(std::string_view source, base::SourceSpan span);

}  // namespace scene
