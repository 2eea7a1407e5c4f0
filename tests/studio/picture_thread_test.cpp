// SPDX-License-Identifier: MIT
// The live picture on a thread of its own, looked at from another one.
#include "studio/picture_thread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "compile/compile.h"
#include "studio/live_outputs.h"

namespace {

using studio::PictureThread;

class PictureThreadTest : public testing::Test {
protected:
    void SetUp() override {
        document.formula = "param r = 1 in [0, 2]\nsphere(r)";
        auto understood = compile::compile_formula(document.formula);
        ASSERT_TRUE(understood);
        formula = std::move(*understood);
        source = compile::program_source(formula, document, studio::live_outputs);
        auto opened = render::open_osmesa();
        ASSERT_TRUE(opened);
        context = std::move(*opened);
        auto linked = render::Program::link(context->gl(), source);
        ASSERT_TRUE(linked);
        program = std::make_unique<render::Program>(std::move(*linked));
        context->release();
        thread.emplace(*context, [this] { ++woken; });
    }
    void TearDown() override { thread.reset(); }

    studio::WantedPicture wanted(int width, int height) const {
        return {document, scene::camera_of(document, double(width) / height),
                compile::field_numbers(formula, source, document), width, height};
    }
    void set_program() {
        thread->set_program(std::move(program), compile::field_numbers(formula, source, document));
    }
    /// Looks again and again, as long as it takes.
    void wait_until_complete() {
        while (!thread->complete()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }

    scene::Document document;
    compile::Formula formula;
    shader::ProgramSource source;
    std::unique_ptr<render::Context> context;
    std::unique_ptr<render::Program> program;
    std::atomic<int> woken = 0;
    std::optional<PictureThread> thread;
};

TEST_F(PictureThreadTest, shows_what_is_wanted_and_says_so) {
    set_program();
    thread->want(wanted(40, 30));
    wait_until_complete();
    while (woken == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const auto news = thread->take_news();
    ASSERT_TRUE(news);
    EXPECT_TRUE(*news);
    const PictureThread::Shown shown = thread->show();
    EXPECT_EQ(shown.layers().width, 40);
    EXPECT_EQ(shown.layers().height, 30);
    EXPECT_NE(shown.layers().full, 0u);
}

TEST_F(PictureThreadTest, draws_nothing_while_it_is_being_looked_at) {
    set_program();
    thread->want(wanted(40, 30));
    wait_until_complete();
    {
        const PictureThread::Shown shown = thread->show();
        thread->want(wanted(50, 20));
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        EXPECT_EQ(shown.layers().width, 40);
        EXPECT_FALSE(thread->complete());
    }
    wait_until_complete();
    EXPECT_EQ(thread->show().layers().width, 50);
}

TEST_F(PictureThreadTest, says_what_went_wrong) {
    set_program();
    thread->want(wanted(1 << 20, 1));
    while (woken == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const auto news = thread->take_news();
    ASSERT_FALSE(news);
    EXPECT_FALSE(thread->complete());
    thread->want(wanted(40, 30));
    wait_until_complete();
}

}  // namespace
