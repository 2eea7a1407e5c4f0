// SPDX-License-Identifier: MIT
// JSON through nlohmann's event interface, which says nothing about places: the iterator that it
// reads from counts along. The only source that includes that library.
#include <algorithm>
#include <cassert>
#include <charconv>
#include <iterator>
#include <limits>
#include <optional>

#include <nlohmann/json.hpp>

#include "scene/json.h"
#include "scene/json_syntax.h"
#include "scene/utf8.h"

namespace scene {
namespace {

/// Deeper texts are not read: values are taken apart by recursion.
constexpr std::size_t deepest = 64;

/// How far the parser has read.
struct Progress {
    std::size_t consumed = 0;
    bool ran_out = false;
};

class CountingIterator {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountingIterator(std::string_view text, std::size_t at, Progress& progress)
        : text_(text), at_(at), progress_(&progress) {}

    const char& operator*() const { return text_[at_]; }
    CountingIterator& operator++() {
        progress_->consumed = ++at_;
        return *this;
    }
    CountingIterator operator++(int) {
        CountingIterator before = *this;
        ++*this;
        return before;
    }
    friend bool operator==(const CountingIterator& a, const CountingIterator& b) {
        if (a.at_ == b.at_) a.progress_->ran_out = true;
        return a.at_ == b.at_;
    }

private:
    std::string_view text_;
    std::size_t at_;
    Progress* progress_;
};

/// Builds the tree from the parser's events.
class TreeBuilder {
public:
    TreeBuilder(std::string_view text, const Progress& progress)
        : text_(text), progress_(&progress) {}

    bool null() { return scalar({}); }
    bool boolean(bool truth) { return scalar(Json::of(truth)); }
    bool number_integer(std::int64_t value) { return number(static_cast<double>(value)); }
    bool number_unsigned(std::uint64_t value) { return number(static_cast<double>(value)); }
    bool number_float(double value, const std::string&) { return number(value); }
    bool string(std::string& text) { return scalar(Json::of(std::move(text))); }
    bool binary(nlohmann::json::binary_t&) { return false; }
    bool start_object(std::size_t) { return open(Json::object()); }
    bool start_array(std::size_t) { return open(Json::of(std::vector<Json>())); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }
    bool key(std::string& name) {
        keys_.push_back({std::move(name), token(), {}});
        after_ = JsonStop::After::key;
        return true;
    }
    bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) {
        JsonStop stop;
        stop.after = done_ ? JsonStop::After::everything : after_;
        stop.in_object = !open_.empty() && open_.back().kind == Json::Kind::object;
        stop.last_end = last_end_;
        stop.consumed = progress_->consumed;
        stop.ran_out = progress_->ran_out;
        problem_ = explain_json_stop(text_, stop);
        return false;
    }

    base::Result<Json> result() && {
        if (problem_) return *std::move(problem_);
        return std::move(root_);
    }

private:
    /// The span of the token that the parser has just reported. A number is only known to be over
    /// when the byte after it has been read, so its end is looked for backwards.
    base::SourceSpan token(bool is_number = false) {
        std::size_t begin = last_end_;
        while (std::string_view(" \n\r\t,:\xEF\xBB\xBF").find(text_[begin]) != std::string::npos) {
            ++begin;
        }
        last_end_ = progress_->consumed;
        constexpr std::string_view digits = "0123456789.eE+-";
        while (is_number && digits.find(text_[last_end_ - 1]) == std::string::npos) --last_end_;
        return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(last_end_)};
    }

    bool number(double value) {
        Json json;
        json.kind = Json::Kind::number;
        json.span = token(true);
        json.text = text_.substr(json.span.begin, json.span.end - json.span.begin);
        json.number = value;
        // The exact value and the sign of zero, whatever way the parser took.
        std::from_chars(json.text.data(), json.text.data() + json.text.size(), json.number);
        return place(std::move(json));
    }

    bool scalar(Json json) {
        json.span = token();
        return place(std::move(json));
    }

    bool open(Json json) {
        json.span = token();
        after_ = JsonStop::After::opening;
        if (open_.size() == deepest) {
            problem_ = base::error(json.span, "the preset is nested too deeply");
            return false;
        }
        open_.push_back(std::move(json));
        return true;
    }

    bool close() {
        Json json = std::move(open_.back());
        open_.pop_back();
        json.span.end = token().end;
        return place(std::move(json));
    }

    /// Puts a finished value where it belongs.
    bool place(Json json) {
        after_ = JsonStop::After::value;
        if (open_.empty()) {
            root_ = std::move(json);
            done_ = true;
        } else if (open_.back().kind == Json::Kind::object) {
            keys_.back().value = std::move(json);
            open_.back().members.push_back(std::move(keys_.back()));
            keys_.pop_back();
        } else {
            open_.back().elements.push_back(std::move(json));
        }
        return true;
    }

    std::string_view text_;
    const Progress* progress_;
    std::size_t last_end_ = 0;
    JsonStop::After after_ = JsonStop::After::nothing;
    bool done_ = false;
    std::vector<Json> open_;        ///< values that are not finished yet, the innermost last
    std::vector<JsonMember> keys_;  ///< names that wait for their values
    Json root_;
    std::optional<base::Diagnostic> problem_;
};

std::optional<base::Diagnostic> encoding_problem(std::string_view text) {
    const std::size_t broken = first_broken_utf8(text);
    const std::size_t zero = text.find('\0');
    const auto at = static_cast<std::uint32_t>(std::min({broken, zero, text.size()}));
    if (at == text.size()) return std::nullopt;
    return base::error({at, at + 1}, zero < broken
                                         ? "the file is not a text: there is a zero byte"
                                         : "the file is not UTF-8 text; save it in that encoding");
}

}  // namespace

base::Result<Json> parse_json(std::string_view text) {
    assert(text.size() < std::numeric_limits<std::uint32_t>::max());
    if (const auto problem = encoding_problem(text)) return *problem;
    Progress progress;
    TreeBuilder builder(text, progress);
    nlohmann::json::sax_parse(CountingIterator(text, 0, progress),
                              CountingIterator(text, text.size(), progress), &builder);
    return std::move(builder).result();
}

}  // namespace scene
