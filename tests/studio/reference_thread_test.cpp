// SPDX-License-Identifier: MIT
// References beside the window: started, answered, given up.
#include "studio/reference_thread.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "fake_trace.h"

namespace {

using studio::ReferenceKey;
using studio::ReferenceThread;
using studio::TracedReference;

void nothing() {}

ReferenceKey key_of(std::string formula, int width = 8) {
    scene::Document document;
    document.formula = std::move(formula);
    return studio::reference_key(document, {}, width, 4, 1);
}

std::optional<TracedReference> answer_of(ReferenceThread& thread) {
    std::optional<TracedReference> answer;
    comes_true([&] { return (answer = thread.take()).has_value(); });
    return answer;
}

TEST(ReferenceThread, answers_with_the_key_and_the_formula_that_were_traced) {
    FakeTrace fake;
    std::atomic<int> woken = 0;
    ReferenceThread thread(fake.function(), [&] { ++woken; });
    EXPECT_FALSE(thread.busy());
    thread.start(key_of("x = 0"));
    const auto answer = answer_of(thread);
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->key, key_of("x = 0"));
    ASSERT_TRUE(answer->formula && answer->reference);
    EXPECT_EQ(answer->reference->width, 8);
    EXPECT_EQ(answer->reference->height, 4);
    EXPECT_TRUE(answer->problems.empty());
    EXPECT_FALSE(thread.busy());
    EXPECT_FALSE(thread.take()) << "an answer comes once";
    EXPECT_TRUE(comes_true([&] { return woken > 0; }));
}

TEST(ReferenceThread, gives_up_the_older_of_two_requests_and_answers_the_newer) {
    FakeTrace fake;
    fake.holds = true;
    ReferenceThread thread(fake.function(), nothing);
    thread.start(key_of("x = 0"));
    ASSERT_TRUE(comes_true([&] { return fake.begun == 1; }));
    EXPECT_TRUE(comes_true([&] { return thread.progress() == 0.25; }));
    thread.start(key_of("y = 0"));
    ASSERT_TRUE(comes_true([&] { return fake.begun == 2; }));
    EXPECT_EQ(fake.given_up, 1);
    EXPECT_TRUE(thread.busy());
    fake.holds = false;
    const auto answer = answer_of(thread);
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->key, key_of("y = 0"));
}

TEST(ReferenceThread, never_answers_what_was_cancelled) {
    FakeTrace fake;
    fake.holds = true;
    ReferenceThread thread(fake.function(), nothing);
    thread.start(key_of("x = 0"));
    ASSERT_TRUE(comes_true([&] { return fake.begun == 1; }));
    thread.cancel();
    EXPECT_FALSE(thread.busy());
    ASSERT_TRUE(comes_true([&] { return fake.given_up == 1; }));
    fake.holds = false;
    thread.start(key_of("y = 0"));
    const auto answer = answer_of(thread);
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->key, key_of("y = 0"));
    // What has been finished but not been taken is forgotten as well.
    thread.start(key_of("z = 0"));
    ASSERT_TRUE(comes_true([&] { return !thread.busy(); }));
    thread.cancel();
    EXPECT_FALSE(thread.take());
}

TEST(ReferenceThread, ends_in_the_middle_of_its_work) {
    FakeTrace fake;
    fake.holds = true;
    {
        ReferenceThread thread(fake.function(), nothing);
        thread.start(key_of("x = 0"));
        ASSERT_TRUE(comes_true([&] { return fake.begun == 1; }));
    }
    EXPECT_EQ(fake.given_up, 1);
}

TEST(ReferenceThread, tells_what_went_wrong) {
    FakeTrace fake;
    ReferenceThread thread(fake.function(), nothing);
    thread.start(key_of("x = "));
    auto answer = answer_of(thread);
    ASSERT_TRUE(answer);
    EXPECT_FALSE(answer->formula);
    EXPECT_TRUE(base::has_errors(answer->problems));
    EXPECT_EQ(fake.begun, 0);
    fake.fails = true;
    thread.start(key_of("x = 0"));
    answer = answer_of(thread);
    ASSERT_TRUE(answer);
    EXPECT_FALSE(answer->reference);
    ASSERT_EQ(answer->problems.size(), 1u);
    EXPECT_EQ(answer->problems[0].message, "the picture is too steep");
}

TEST(ReferenceThread, survives_an_exception_from_below) {
    ReferenceThread thread(
        [](const compile::Formula&, const scene::Document&, const oracle::Query&)
            -> base::Result<oracle::Reference> { throw std::runtime_error("no memory"); },
        nothing);
    thread.start(key_of("x = 0"));
    const auto answer = answer_of(thread);
    ASSERT_TRUE(answer && !answer->problems.empty());
    EXPECT_EQ(answer->problems[0].message, "internal error while checking: no memory");
}

}  // namespace
