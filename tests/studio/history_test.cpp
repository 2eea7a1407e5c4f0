// SPDX-License-Identifier: MIT
// Undo and redo.
#include "studio/history.h"

#include <string>

#include <gtest/gtest.h>

namespace {

using studio::Gesture;
using studio::History;

scene::Document named(const std::string& title) {
    scene::Document document;
    document.title = title;
    return document;
}

constexpr Gesture no_gesture{};

TEST(History, begins_with_nothing_to_undo) {
    History history(named("a"));
    EXPECT_FALSE(history.can_undo());
    EXPECT_FALSE(history.can_redo());
    EXPECT_EQ(history.undo().title, "a");
    EXPECT_EQ(history.redo().title, "a");
}

TEST(History, goes_back_and_forth_over_separate_changes) {
    History history(named("a"));
    history.record(named("b"), no_gesture, 1);
    history.record(named("c"), no_gesture, 1.01);
    EXPECT_EQ(history.undo().title, "b");
    EXPECT_EQ(history.undo().title, "a");
    EXPECT_FALSE(history.can_undo());
    EXPECT_EQ(history.redo().title, "b");
    EXPECT_EQ(history.redo().title, "c");
    EXPECT_FALSE(history.can_redo());
}

TEST(History, ignores_a_value_that_is_present_already) {
    History history(named("a"));
    history.record(named("a"), no_gesture, 1);
    EXPECT_FALSE(history.can_undo());
}

TEST(History, keeps_what_can_be_redone_while_nothing_changes) {
    History history(named("a"));
    history.record(named("b"), no_gesture, 1);
    history.undo();
    history.record(named("a"), no_gesture, 2);
    EXPECT_EQ(history.redo().title, "b");
}

TEST(History, forgets_what_could_be_redone_after_a_change) {
    History history(named("a"));
    history.record(named("b"), no_gesture, 1);
    history.undo();
    history.record(named("c"), no_gesture, 2);
    EXPECT_FALSE(history.can_redo());
    EXPECT_EQ(history.undo().title, "a");
}

TEST(History, makes_one_step_of_a_held_gesture_however_long_it_takes) {
    History history(named("a"));
    const Gesture drag{7, true};
    history.record(named("b"), drag, 1);
    history.record(named("c"), drag, 20);
    history.record(named("d"), drag, 60);
    EXPECT_EQ(history.undo().title, "a");
    EXPECT_EQ(history.redo().title, "d");
}

TEST(History, makes_two_steps_of_two_drags) {
    History history(named("a"));
    history.record(named("b"), {7, true}, 1);
    history.record(named("c"), {8, true}, 1.01);
    EXPECT_EQ(history.undo().title, "b");
}

TEST(History, ends_a_burst_of_typing_with_a_pause) {
    History history(named(""));
    const Gesture typing{9, false};
    history.record(named("x"), typing, 1);
    history.record(named("xy"), typing, 1.2);
    history.record(named("xyz"), typing, 1.2 + 2 * History::pause_seconds);
    EXPECT_EQ(history.undo().title, "xy");
    EXPECT_EQ(history.undo().title, "");
}

TEST(History, does_not_merge_into_a_value_that_was_undone_to) {
    History history(named("a"));
    const Gesture typing{9, false};
    history.record(named("b"), typing, 1);
    history.record(named("c"), {10, true}, 1.1);
    history.undo();
    history.record(named("d"), typing, 1.2);
    EXPECT_EQ(history.undo().title, "b");
}

TEST(History, covers_every_part_of_the_document) {
    scene::Document document;
    History history(document);
    const scene::Document first = document;
    document.formula = "x = 0";
    history.record(document, no_gesture, 1);
    document.parameters["a"] = 2.0;
    history.record(document, no_gesture, 1);
    document.camera = scene::Camera{};
    history.record(document, no_gesture, 1);
    document.lights.clear();
    history.record(document, no_gesture, 1);
    document.materials.emplace_back();
    history.record(document, no_gesture, 1);
    document.environment.sky.x = 1;
    history.record(document, no_gesture, 1);
    document.settings.steps = 99;
    history.record(document, no_gesture, 1);
    document.bounds.centre.y = 3;
    history.record(document, no_gesture, 1);
    document.time = 5;
    history.record(document, no_gesture, 1);
    int steps = 0;
    for (; history.can_undo(); history.undo()) ++steps;
    EXPECT_EQ(steps, 9);
    EXPECT_EQ(history.present(), first);
}

TEST(History, forgets_the_oldest_of_very_many_steps) {
    History history(named("first"));
    for (int i = 0; i < 1500; ++i) history.record(named(std::to_string(i)), no_gesture, i);
    std::size_t steps = 0;
    for (; history.can_undo(); history.undo()) ++steps;
    EXPECT_EQ(steps, History::most_steps);
    EXPECT_EQ(history.present().title, "499");
}

}  // namespace
