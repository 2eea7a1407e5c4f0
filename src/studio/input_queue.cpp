// SPDX-License-Identifier: MIT
#include "studio/input_queue.h"

#include <cfloat>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

namespace studio {
namespace {

/// Linux's key code of the key Linefeed, which GLFW does not know; programs that type for people
/// send it for the end of a line.
constexpr int linefeed_scancode = 109;

/// Shortcuts are meant by letter, GLFW's key codes by place: translate to the user's layout.
int by_letter(int key, int scancode) {
    if (key == GLFW_KEY_UNKNOWN && scancode == linefeed_scancode) return GLFW_KEY_ENTER;
    if (key < GLFW_KEY_A || key > GLFW_KEY_Z) return key;
    const char* name = glfwGetKeyName(key, scancode);
    if (!name || name[0] == '\0' || name[1] != '\0') return key;
    if (name[0] >= 'a' && name[0] <= 'z') return GLFW_KEY_A + (name[0] - 'a');
    if (name[0] >= 'A' && name[0] <= 'Z') return GLFW_KEY_A + (name[0] - 'A');
    return key;
}

bool is_modifier(int key) { return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER; }

bool is_shift(int key) { return key == GLFW_KEY_LEFT_SHIFT || key == GLFW_KEY_RIGHT_SHIFT; }

/// In a text field the printable keys do nothing themselves: their characters follow, and a whole
/// burst of typing fits into one frame.
bool only_types(int key, int modifiers) {
    constexpr int commands = GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER;
    const bool printable = key >= GLFW_KEY_SPACE && key < GLFW_KEY_ESCAPE;
    return ImGui::GetIO().WantTextInput && (printable || is_shift(key)) && !(modifiers & commands);
}

template <class... Handlers>
struct Overloaded : Handlers... {
    using Handlers::operator()...;
};
template <class... Handlers>
Overloaded(Handlers...) -> Overloaded<Handlers...>;

}  // namespace

InputQueue::InputQueue(GLFWwindow* window) : window_(window) {
    double x = 0, y = 0;
    glfwGetCursorPos(window, &x, &y);
    position_ = {static_cast<float>(x), static_cast<float>(y)};
    inside_ = glfwGetWindowAttrib(window, GLFW_HOVERED);
    glfwSetWindowUserPointer(window, this);
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int modifiers) {
        of(w).push(Key{by_letter(key, scancode), scancode, action, modifiers});
    });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned code) { of(w).push(Character{code}); });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int modifiers) {
        of(w).push(Button{button, action, modifiers});
    });
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
        of(w).push(Move{static_cast<float>(x), static_cast<float>(y)});
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
        of(w).push(Scroll{x, y});
    });
    glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
        if (!entered) of(w).push(Leave{});
    });
    glfwSetWindowFocusCallback(window,
                               [](GLFWwindow* w, int focused) { of(w).push(Focus{focused != 0}); });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { of(w).news_ = true; });
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { of(w).news_ = true; });
    glfwSetWindowContentScaleCallback(window,
                                      [](GLFWwindow* w, float, float) { of(w).news_ = true; });
    glfwSetWindowCloseCallback(window, [](GLFWwindow* w) { of(w).news_ = true; });
}

InputQueue::~InputQueue() {
    glfwSetKeyCallback(window_, nullptr);
    glfwSetCharCallback(window_, nullptr);
    glfwSetMouseButtonCallback(window_, nullptr);
    glfwSetCursorPosCallback(window_, nullptr);
    glfwSetScrollCallback(window_, nullptr);
    glfwSetCursorEnterCallback(window_, nullptr);
    glfwSetWindowFocusCallback(window_, nullptr);
    glfwSetWindowRefreshCallback(window_, nullptr);
    glfwSetFramebufferSizeCallback(window_, nullptr);
    glfwSetWindowContentScaleCallback(window_, nullptr);
    glfwSetWindowCloseCallback(window_, nullptr);
    glfwSetWindowUserPointer(window_, nullptr);
}

InputQueue& InputQueue::of(GLFWwindow* window) {
    return *static_cast<InputQueue*>(glfwGetWindowUserPointer(window));
}

void InputQueue::push(Event event) {
    events_.push_back(event);
    news_ = true;
}

void InputQueue::feed() {
    Fed fed;
    while (!events_.empty() && fits(events_.front(), fed)) {
        apply(events_.front(), fed);
        events_.pop_front();
    }
    news_ = false;
    ImGuiIO& io = ImGui::GetIO();
    const bool held = buttons_[0] || buttons_[1] || buttons_[2];
    io.MousePos = inside_ || held ? ImVec2(position_.x, position_.y) : ImVec2(-FLT_MAX, -FLT_MAX);
    for (int i = 0; i < 3; ++i) io.MouseDown[i] = buttons_[i];
}

/// Order counts: a click belongs to the place where the mouse was, and ImGui must have seen the
/// mouse there one frame earlier; a character belongs to the text that the keys before it have
/// left.
bool InputQueue::fits(const Event& event, const Fed& fed) {
    return std::visit(
        Overloaded{[&](const Key& e) {
                       if (only_types(e.key, e.modifiers)) return fed.keys.empty();
                       if (is_modifier(e.key))
                           return fed.keys.empty() && !fed.character && !fed.button;
                       return !fed.keys.contains(e.key) && !fed.character;
                   },
                   [&](const Character&) { return !fed.shortcut_key; },
                   [&](const Button& e) {
                       return !fed.buttons.contains(e.button) && !fed.scroll && !fed.move;
                   },
                   [&](const Move&) { return !fed.button && !fed.scroll; },
                   [&](const Scroll&) { return !fed.button; }, [](const Focus&) { return true; },
                   [&](const Leave&) { return !fed.button && !fed.scroll; }},
        event);
}

void InputQueue::apply(const Event& event, Fed& fed) {
    std::visit(
        Overloaded{[&](const Key& e) {
                       ImGui_ImplGlfw_KeyCallback(window_, e.key, e.scancode, e.action,
                                                  e.modifiers);
                       if (e.action == GLFW_REPEAT) return;
                       if (only_types(e.key, e.modifiers)) return;
                       fed.keys.insert(e.key);
                       fed.shortcut_key = fed.shortcut_key || !is_modifier(e.key);
                   },
                   [&](const Character& e) {
                       ImGui::GetIO().AddInputCharacter(e.code);
                       fed.character = true;
                   },
                   [&](const Button& e) {
                       if (e.button < 0 || e.button >= 3) return;
                       buttons_[e.button] = e.action == GLFW_PRESS;
                       fed.buttons.insert(e.button);
                       fed.button = true;
                   },
                   [&](const Move& e) {
                       position_ = e;
                       inside_ = true;
                       fed.move = true;
                   },
                   [&](const Scroll& e) {
                       ImGui_ImplGlfw_ScrollCallback(window_, e.x, e.y);
                       fed.scroll = true;
                   },
                   [&](const Focus& e) { ImGui_ImplGlfw_WindowFocusCallback(window_, e.focused); },
                   [&](const Leave&) { inside_ = false; }},
        event);
}

}  // namespace studio
