// SPDX-License-Identifier: MIT
// The thread that compiles, asked from another one.
#include "studio/compiler_thread.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace {

using studio::CompilerThread;

/// Waits for answers.
class Answers {
public:
    void wake() {
        const std::lock_guard lock(mutex_);
        ++news_;
        changed_.notify_one();
    }
    /// Whether numbers like these come within a minute, and no program after the first one.
    bool come_to(const shader::FieldNumbers& expected, CompilerThread& thread) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
        while (true) {
            const auto scene = thread.take_scene();
            if (scene && scene->program) ++programs;
            if (scene && scene->field_numbers == expected) return !scene->field_numbers->coarse;
            std::unique_lock lock(mutex_);
            if (!changed_.wait_until(lock, end, [&] { return news_ > 0; })) return false;
            news_ = 0;
        }
    }

    int programs = 0;

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    int news_ = 0;
};

shader::FieldNumbers close_numbers(const scene::Document& document) {
    studio::SceneBuilder patient([](const shader::ProgramSource&) {
        return base::Result<std::unique_ptr<render::Program>>(std::unique_ptr<render::Program>());
    });
    const auto built = patient.build(document, [] { return false; });
    EXPECT_TRUE(built && built->field_numbers);
    return built->field_numbers.value();
}

TEST(CompilerThread, ends_with_close_bounds_however_short_of_time_it_was) {
    auto opened = render::open_osmesa();
    ASSERT_TRUE(opened);
    const std::unique_ptr<render::Context> context = std::move(*opened);
    context->release();
    Answers answers;
    CompilerThread thread(*context, [&] { answers.wake(); });
    scene::Document document;
    // Takes long to analyse.
    document.formula =
        "param s = 0.05 in [0, 1]\n"
        "bead(i) = translate(sphere(s), (sin(i), sin(2.1i), sin(3.3i)))\n"
        "smooth_union(bead, 400, 0.1)";
    thread.request(document);
    EXPECT_TRUE(answers.come_to(close_numbers(document), thread));
    // A slider is dragged, and then at rest.
    for (const double size : {0.06, 0.07, 0.08}) {
        document.parameters["s"] = size;
        thread.request(document);
    }
    EXPECT_TRUE(answers.come_to(close_numbers(document), thread));
    EXPECT_EQ(answers.programs, 1);
}

}  // namespace
