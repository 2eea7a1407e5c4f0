// SPDX-License-Identifier: MIT
// Events of the window in the order in which they came, handed to the user interface so that none
// is lost: a key that is pressed and released between two frames is seen down in one frame and up
// in the next.
#pragma once

#include <deque>
#include <set>
#include <variant>

struct GLFWwindow;

namespace studio {

/// Takes over the window's callbacks as long as it lives. Dear ImGui 1.86 only sees the state of
/// keys and buttons at the time of a frame; on a slow machine that loses quick clicks and keys.
class InputQueue {
public:
    explicit InputQueue(GLFWwindow* window);
    ~InputQueue();
    InputQueue(const InputQueue&) = delete;
    InputQueue& operator=(const InputQueue&) = delete;

    /// True if something has happened since the last `feed`, or is still waiting for the next one.
    bool has_news() const { return news_ || !events_.empty(); }
    /// Hands events to ImGui's input state, as many as one frame can tell apart. To be called
    /// between the back end's new frame and ImGui::NewFrame.
    void feed();

private:
    struct Key {
        int key, scancode, action, modifiers;
    };
    struct Character {
        unsigned code;
    };
    struct Button {
        int button, action, modifiers;
    };
    struct Move {
        float x, y;
    };
    struct Scroll {
        double x, y;
    };
    struct Focus {
        bool focused;
    };
    struct Leave {};
    using Event = std::variant<Key, Character, Button, Move, Scroll, Focus, Leave>;

    /// What has been fed in this frame, as far as it keeps something else out of it.
    struct Fed {
        std::set<int> keys, buttons;
        bool character = false, shortcut_key = false, button = false, scroll = false;
        bool move = false;
    };

    static InputQueue& of(GLFWwindow* window);
    void push(Event event);
    static bool fits(const Event& event, const Fed& fed);
    void apply(const Event& event, Fed& fed);

    GLFWwindow* window_;
    std::deque<Event> events_;
    bool news_ = true;
    Move position_;
    bool inside_ = false;
    bool buttons_[3] = {false, false, false};
};

}  // namespace studio
