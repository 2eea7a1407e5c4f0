// SPDX-License-Identifier: MIT
// Well-formed and broken characters.
#include "scene/utf8.h"

#include <gtest/gtest.h>

namespace {

TEST(Utf8, knows_the_length_of_characters) {
    EXPECT_EQ(scene::utf8_length("a", 0), 1u);
    EXPECT_EQ(scene::utf8_length("\xC3\xA4", 0), 2u);
    EXPECT_EQ(scene::utf8_length("\xE2\x82\xAC", 0), 3u);
    EXPECT_EQ(scene::utf8_length("\xF0\x9F\x98\x80", 0), 4u);
    EXPECT_EQ(scene::utf8_length("\xF4\x8F\xBF\xBF", 0), 4u);
    EXPECT_EQ(scene::utf8_length("", 0), 0u);
}

TEST(Utf8, rejects_what_is_no_character) {
    for (const char* text :
         {"\x80", "\xBF", "\xC0\x80", "\xC1\xBF", "\xC3", "\xC3x", "\xE0\x9F\xBF", "\xED\xA0\x80",
          "\xE2\x82", "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF"}) {
        EXPECT_EQ(scene::utf8_length(text, 0), 0u) << text;
    }
}

TEST(Utf8, finds_the_first_broken_byte) {
    EXPECT_EQ(scene::first_broken_utf8("plain"), 5u);
    EXPECT_EQ(scene::first_broken_utf8("\xC3\xA4\xC3"), 2u);
}

}  // namespace
