// SPDX-License-Identifier: MIT
// JSON with places: every value knows its bytes, and one value has one spelling.
#include "scene/json.h"

#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

using scene::Json;

Json parsed(std::string_view text) {
    base::Result<Json> json = scene::parse_json(text);
    EXPECT_TRUE(json) << text << ": " << (json ? "" : json.problems()[0].message);
    return json ? *json : Json();
}

std::string at(std::string_view text, base::SourceSpan span) {
    return std::string(text.substr(span.begin, span.end - span.begin));
}

/// Every value's span is the text of that very value, and every key's span that of the key.
void expect_spans(std::string_view text, const Json& json) {
    const Json again = parsed(at(text, json.span));
    EXPECT_EQ(scene::print_json_compact(again), scene::print_json_compact(json));
    for (const Json& element : json.elements) expect_spans(text, element);
    for (const scene::JsonMember& member : json.members) {
        EXPECT_EQ(parsed(at(text, member.key_span)).text, member.key);
        expect_spans(text, member.value);
    }
}

TEST(Json, knows_the_bytes_of_every_value) {
    const std::string text =
        "\xEF\xBB\xBF { \"a\\\"b\" : [1,-2.5e3 ,0.5, -0],\n\t\"c\":{\"d\":{},\"e\":[ ]}, "
        "\"f\": true,\"g\":null , \"\xC3\xA4\\u00e4\" : \"tab\\t\\\\\",\"h\":12}\n";
    const Json json = parsed(text);
    expect_spans(text, json);
    ASSERT_EQ(json.members.size(), 6u);
    EXPECT_EQ(at(text, json.members[0].key_span), "\"a\\\"b\"");
    EXPECT_EQ(at(text, json.members[0].value.span), "[1,-2.5e3 ,0.5, -0]");
    EXPECT_EQ(at(text, json.members[0].value.elements[1].span), "-2.5e3");
    EXPECT_EQ(at(text, json.members[0].value.elements[3].span), "-0");
    EXPECT_TRUE(std::signbit(json.members[0].value.elements[3].number));
    EXPECT_EQ(at(text, json.find("f")->span), "true");
    EXPECT_EQ(json.find("\xC3\xA4\xC3\xA4")->text, "tab\t\\");
    EXPECT_EQ(at(text, json.find("h")->span), "12");
}

/// A random value and its text with random white space.
std::string random_json(std::mt19937& random, int depth) {
    const auto space = [&] { return std::string(random() % 3, " \n\t"[random() % 3]); };
    std::string inner;
    switch (random() % (depth > 0 ? 7 : 5)) {
        case 0:
            return "null";
        case 1:
            return random() % 2 ? "true" : "false";
        case 2:
            return fmt::format("{}", static_cast<int>(random() % 2000) - 1000);
        case 3:
            return fmt::format("{}", (random() % 10000 - 5000.0) * 1.25e-3);
        case 4:
            return "\"\\u20ac\\\"" + std::string(random() % 5, 'x') + "\\\\\"";
        case 5:
            for (unsigned i = random() % 4; i-- > 0;) {
                inner +=
                    (inner.empty() ? "" : ",") + space() + random_json(random, depth - 1) + space();
            }
            return fmt::format("[{}]", inner);
        default:
            for (unsigned i = random() % 4; i-- > 0;) {
                inner += (inner.empty() ? "" : ",") + space() + fmt::format("\"k{}\"", i) +
                         space() + ':' + space() + random_json(random, depth - 1) + space();
            }
            return fmt::format("{{{}}}", inner);
    }
}

TEST(Json, knows_the_bytes_of_every_value_in_random_texts) {
    for (unsigned seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(fmt::format("seed {}", seed));
        std::mt19937 random(seed);
        const std::string text = ' ' + random_json(random, 4) + '\n';
        const Json json = parsed(text);
        expect_spans(text, json);
        const std::string printed = scene::print_json(json);
        EXPECT_EQ(scene::print_json(parsed(printed)), printed);
        EXPECT_EQ(scene::print_json_compact(parsed(printed)), scene::print_json_compact(json));
    }
}

TEST(Json, is_printed_with_lists_of_numbers_on_one_line) {
    const Json json = parsed(R"({"a":[1,2.50,-3],"b":{"c":[1,2]},"d":["x"],"e":{"f":1,"g":{}}})");
    EXPECT_EQ(scene::print_json(json),
              "{\n"
              "  \"a\": [1, 2.50, -3],\n"
              "  \"b\": {\"c\": [1, 2]},\n"
              "  \"d\": [\n"
              "    \"x\"\n"
              "  ],\n"
              "  \"e\": {\n"
              "    \"f\": 1,\n"
              "    \"g\": {}\n"
              "  }\n"
              "}");
}

TEST(Json, escapes_what_json_cannot_hold) {
    EXPECT_EQ(scene::print_json(Json::of(std::string("\"\\\n\t\r\x01\x7F\xC3\xA4\xFF", 10))),
              "\"\\\"\\\\\\n\\t\\r\\u0001\\u007f\xC3\xA4\\ufffd\"");
}

TEST(Json, writes_numbers_in_the_shortest_form_that_reads_back) {
    EXPECT_EQ(Json::of(0.1).text, "0.1");
    EXPECT_EQ(Json::of(100000.0).text, "100000");
    EXPECT_EQ(Json::of(1.0 / 3).text, "0.3333333333333333");
    EXPECT_EQ(Json::of(1e-7).text, "1e-07");
}

TEST(TextPlaces, lead_each_byte_back_through_its_escape) {
    const std::string text = "[\"a\\n\xC3\xA4\\u20ac\\ud83d\\ude00z\"]";
    const Json json = parsed(text);
    const Json& value = json.elements[0];
    const auto places = scene::text_places(text, value.span);
    //  "     a  \n  ae umlaut  euro (3 bytes)  emoji (4 bytes)      z   end
    const std::vector<std::uint32_t> expected{2, 3, 5, 6, 7, 7, 7, 13, 13, 13, 13, 25, 26};
    EXPECT_EQ(places, expected);
    EXPECT_EQ(places.size(), value.text.size() + 1);
}

/// The message and the marked bytes of a text that is no JSON.
std::string syntax_error(const std::string& text) {
    const base::Result<Json> json = scene::parse_json(text);
    if (json) return "no error";
    EXPECT_EQ(json.problems().size(), 1u);
    const base::Diagnostic problem = json.problems()[0];
    return fmt::format("{}|{}|{}", problem.span->begin, at(text, *problem.span), problem.message);
}

TEST(JsonSyntax, tells_that_a_file_is_empty_or_cut_off) {
    EXPECT_EQ(syntax_error(""), "0||the file is empty");
    EXPECT_EQ(syntax_error(" \n "), "0||the file is empty");
    const std::string cut = "the file ends in the middle of the preset; it may have been cut off";
    const std::string whole = R"({"a": [1, -2.5e+3, true], "b\n": {"c": null, "d": "x"}})";
    for (std::size_t size = 1; size < whole.size(); ++size) {
        const std::string text = whole.substr(0, size);
        const std::size_t end = text.find_last_not_of(' ') + 1;
        EXPECT_EQ(syntax_error(text), fmt::format("{}||{}", end, cut)) << text;
    }
}

TEST(JsonSyntax, explains_mistakes_in_plain_words) {
    const std::pair<const char*, const char*> mistakes[] = {
        {"x", "0|x|unknown word x; texts stand between double quotes"},
        {"]", "0|]|a preset begins with '{'"},
        {"{} x", "3|x|there is more text after the end of the preset"},
        {"{} 5", "3|5|there is more text after the end of the preset"},
        {"{\"a\": NaN}", "6|NaN|NaN is not a number; write a finite one"},
        {"{\"a\": -Infinity}", "6|-Infinity|-Infinity is not a number; write a finite one"},
        {"[1, inf]", "4|inf|inf is not a number; write a finite one"},
        {"[True]", "1|True|unknown word True; did you mean true?"},
        {"[hello]", "1|hello|unknown word hello; texts stand between double quotes"},
        {"['a']", "1|'|texts stand between double quotes, not single ones"},
        {"[1] // x", "4|/|there is more text after the end of the preset"},
        {"{ // x\n}", "2|/|a preset cannot hold comments; use the field 'description'"},
        {"[1e999]", "1|1e999|the number 1e999 is too large"},
        {"{\"a\": -1e999}", "6|-1e999|the number -1e999 is too large"},
        {"[01]", "1|01|01 is not a number as JSON writes it, such as -0.5 or 1e-3"},
        {"[1.2.3]", "1|1.2.3|1.2.3 is not a number as JSON writes it, such as -0.5 or 1e-3"},
        {"[5px]", "1|5px|5px is not a number as JSON writes it, such as -0.5 or 1e-3"},
        {"[.5]", "1|.5|.5 is not a number as JSON writes it, such as -0.5 or 1e-3"},
        {"[+1]", "1|+1|+1 is not a number as JSON writes it, such as -0.5 or 1e-3"},
        {"[1.]", "1|1.|1. is not a number as JSON writes it, such as -0.5 or 1e-3"},
        {"[1 2]", "3|2|a ',' or ']' is missing"},
        {"{\"a\": 1 \"b\": 2}", "8|\"|a ',' or '}' is missing"},
        {"{\"a\" 1}", "5|1|a ':' is missing after the name of a field"},
        {"{\"a\": }", "6|}|the value of the field is missing"},
        {"{\"a\": 1,}", "8|}|the ',' before this bracket must go"},
        {"[1, ]", "4|]|the ',' before this bracket must go"},
        {"[,1]", "1|,|a value, or ']', is missing"},
        {"[1,,2]", "3|,|a value is missing"},
        {"{1: 2}", "1|1|the name of a field in double quotes, or '}', is missing"},
        {"{\"a\": 1, 2}", "9|2|the name of a field in double quotes is missing"},
        {"{\"a\": [1}", "8|}|a ',' or ']' is missing"},
        {"[\"a\nb\"]",
         "1|\"a|a text must be closed with '\"' on its own line; write \\n for a line break in it"},
        {"[\"a\tb\"]",
         "1|\"a|a text cannot hold a control character such as a tab; write \\t for a tab"},
        {"[\"a\\qb\"]",
         "3|\\q|this backslash has no meaning in a text; write \\\\ for a backslash"},
        {"[\"\\u12g4\"]", "2|\\u|\\u needs four hexadecimal digits"},
        {"[\"\\ud800x\"]", "2|\\ud800|this \\u is half of a character; write the character itself"},
        {"[\"\\udc00\"]", "2|\\udc00|this \\u is half of a character; write the character itself"},
        {"[\"\xFF\"]", "2|\xFF|the file is not UTF-8 text; save it in that encoding"},
    };
    for (const auto& [text, expected] : mistakes) EXPECT_EQ(syntax_error(text), expected) << text;
    EXPECT_EQ(syntax_error(std::string("[1]\0", 4)),
              std::string("3|\0|the file is not a text: there is a zero byte", 48));
}

TEST(JsonSyntax, refuses_to_nest_too_deeply) {
    EXPECT_EQ(syntax_error(std::string(64, '[') + std::string(64, ']')), "no error");
    EXPECT_EQ(syntax_error(std::string(100000, '[')), "64|[|the preset is nested too deeply");
}

TEST(JsonSyntax, always_answers_with_a_place_in_the_text) {
    const std::string whole =
        R"({"zeroset": 1, "a": [1, -2.5e+3, true, "\u00e4\\"], "b": {"c": null}})";
    for (unsigned seed = 0; seed < 3000; ++seed) {
        std::mt19937 random(seed);
        std::string text = whole;
        for (unsigned i = 1 + random() % 3; i-- > 0;) {
            constexpr std::string_view signs = "{}[],:\"\\ \n\t0-.eEtxu/'#\xC3";
            const std::size_t place = random() % text.size();
            if (random() % 2) {
                text[place] = signs[random() % signs.size()];
            } else {
                text.erase(place, 1 + random() % 3);
            }
        }
        const base::Result<Json> json = scene::parse_json(text);
        if (json) continue;
        ASSERT_TRUE(json.problems()[0].span) << "seed " << seed << ": " << text;
        const base::SourceSpan span = *json.problems()[0].span;
        EXPECT_LE(span.begin, span.end) << "seed " << seed << ": " << text;
        EXPECT_LE(span.end, text.size()) << "seed " << seed << ": " << text;
        EXPECT_FALSE(json.problems()[0].message.empty()) << "seed " << seed << ": " << text;
    }
}

}  // namespace
