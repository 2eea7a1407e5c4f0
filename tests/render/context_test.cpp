// SPDX-License-Identifier: MIT
// Opening, switching and closing contexts.
#include "render/context.h"

#include <array>
#include <cstring>
#include <thread>

#include "render/small_programs.h"
#include "render/still.h"

namespace {

using render_test::text;

image::Picture draw(render::Context& context, int width, int height) {
    const auto still =
        render::draw_still(context, render_test::coordinates(), {}, render_test::frame_of,
                           render::whole(width, height), render_test::picture_only);
    EXPECT_TRUE(still) << text(still);
    return still ? still->picture : image::Picture();
}

render::Gl::Function without_two_functions(const char* name) {
    if (std::strcmp(name, "glDrawArrays") == 0 || std::strcmp(name, "glFinish") == 0)
        return nullptr;
    return [] {};
}

TEST(Gl, names_the_functions_that_a_driver_lacks) {
    const auto gl = render::Gl::load(without_two_functions);
    ASSERT_FALSE(gl);
    EXPECT_EQ(text(gl),
              "the OpenGL driver lacks glDrawArrays, glFinish; OpenGL 4.5 is needed, update the "
              "graphics driver\n");
}

// What a driver with every function but an old version answers.
void report_version_4_3(GLenum name, GLint* value) { *value = name == GL_MAJOR_VERSION ? 4 : 3; }

render::Gl::Function old_driver(const char* name) {
    if (std::strcmp(name, "glGetIntegerv") == 0)
        return reinterpret_cast<render::Gl::Function>(report_version_4_3);
    return [] {};
}

TEST(Gl, refuses_a_version_below_4_5) {
    const auto gl = render::Gl::load(old_driver);
    ASSERT_FALSE(gl);
    EXPECT_EQ(text(gl),
              "the driver offers OpenGL 4.3, but 4.5 is needed; update the graphics driver\n");
}

TEST(Osmesa, tells_its_renderer_and_its_largest_size) {
    const auto context = render::open_osmesa();
    ASSERT_TRUE(context) << text(context);
    EXPECT_NE((*context)->renderer(), "");
    EXPECT_NE((*context)->renderer(), "unknown");
    EXPECT_GE((*context)->largest_size(), 4096);
}

TEST(Osmesa, two_contexts_work_side_by_side) {
    auto first = render::open_osmesa();
    ASSERT_TRUE(first) << text(first);
    auto second = render::open_osmesa();
    ASSERT_TRUE(second) << text(second);
    (*first)->make_current();
    const image::Picture a = draw(**first, 40, 30);
    (*second)->make_current();
    const image::Picture b = draw(**second, 40, 30);
    EXPECT_EQ(a, b);

    // Closing one that is not current leaves the other as it is.
    first->reset();
    EXPECT_EQ(draw(**second, 40, 30), b);
}

TEST(Osmesa, contexts_work_on_two_threads_at_once) {
    std::array<image::Picture, 2> pictures;
    const auto work = [&](std::size_t i) {
        auto context = render::open_osmesa();
        ASSERT_TRUE(context) << text(context);
        pictures[i] = draw(**context, 64, 48);
    };
    std::thread other(work, 1);
    work(0);
    other.join();
    EXPECT_EQ(pictures[0].width, 64);
    EXPECT_EQ(pictures[0], pictures[1]);
}

TEST(Osmesa, a_released_context_can_go_on_in_another_thread) {
    auto context = render::open_osmesa();
    ASSERT_TRUE(context) << text(context);
    const image::Picture before = draw(**context, 20, 10);
    (*context)->release();
    image::Picture after;
    std::thread([&] {
        (*context)->make_current();
        after = draw(**context, 20, 10);
        (*context)->release();
    }).join();
    EXPECT_EQ(after, before);
}

TEST(Window, wraps_a_context_that_another_library_has_made) {
    const auto owner = render::open_osmesa();
    ASSERT_TRUE(owner) << text(owner);
    static render::Context* current = nullptr;
    static render::Context* lender = owner->get();
    const auto wrapped = render::wrap_window(
        lender,
        [](const char* name) {
#define GL_FUNCTION(member, type)             \
    if (std::strcmp(name, "gl" #member) == 0) \
        return reinterpret_cast<render::Gl::Function>(lender->gl().member);
#include "render/gl_functions.def"
#undef GL_FUNCTION
            return render::Gl::Function(nullptr);
        },
        [](void* window) { current = static_cast<render::Context*>(window); });
    ASSERT_TRUE(wrapped) << text(wrapped);
    (*wrapped)->make_current();
    EXPECT_EQ(current, lender);
    (*wrapped)->release();
    EXPECT_EQ(current, nullptr);
    EXPECT_EQ((*wrapped)->renderer(), lender->renderer());
}

TEST(Egl, draws_the_same_coordinates_where_a_display_is_available) {
    auto context = render::open_egl();
    if (!context) GTEST_SKIP() << "not run, EGL cannot be used here: " << text(context);
    const image::Picture picture = draw(**context, 33, 21);
    ASSERT_EQ(picture.width, 33);
    for (int y = 0; y < 21; ++y)
        for (int x = 0; x < 33; ++x) {
            ASSERT_EQ(picture.at(x, y)[0], x);
            ASSERT_EQ(picture.at(x, y)[1], y);
        }
}

TEST(Egl, works_beside_osmesa_and_a_second_egl_context) {
    auto egl = render::open_egl();
    if (!egl) GTEST_SKIP() << "not run, EGL cannot be used here: " << text(egl);
    const image::Picture first = draw(**egl, 16, 16);
    (*egl)->release();
    auto osmesa = render::open_osmesa();
    ASSERT_TRUE(osmesa) << text(osmesa);
    EXPECT_EQ(draw(**osmesa, 16, 16), first);
    (*osmesa)->release();
    auto second = render::open_egl();
    ASSERT_TRUE(second) << text(second);
    EXPECT_EQ(draw(**second, 16, 16), first);
    second->reset();
    (*egl)->make_current();
    EXPECT_EQ(draw(**egl, 16, 16), first);
}

}  // namespace
