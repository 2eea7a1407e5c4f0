// SPDX-License-Identifier: MIT
// Dear ImGui in the studio's window: fonts, colours, sizes, and the frame around the panels.
#pragma once

#include "studio/window.h"

struct ImFont;

namespace studio {

/// Owns ImGui's context and back ends. The window's context must be current for every call.
class Gui {
public:
    explicit Gui(Window& window);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    /// The font for formulas and their diagnostics.
    ImFont* monospaced() const { return monospaced_; }
    /// Lengths given in pixels of an ordinary screen are multiplied by this.
    float scale() const { return scale_; }

    /// What comes before and after ImGui::NewFrame ... ImGui::Render. `begin` adapts fonts and
    /// style where the window has been moved to a screen of another density.
    void begin();
    /// Draws what ImGui::Render has made onto the window's own frame buffer.
    void draw();

private:
    void load_fonts(float scale);
    void adapt();

    Window& window_;
    ImFont* monospaced_ = nullptr;
    float scale_ = 1;
    float content_scale_ = 0;
};

}  // namespace studio
