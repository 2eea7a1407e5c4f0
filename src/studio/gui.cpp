// SPDX-License-Identifier: MIT
#include "studio/gui.h"

#include <filesystem>

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

namespace studio {
namespace {

constexpr float text_height = 15, code_height = 14;
constexpr const char* text_font = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr const char* code_font = "/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf";

/// The font of this file if it is there, else ImGui's own, which is monospaced.
ImFont* load_font(const char* file, float pixels) {
    static constexpr ImWchar ranges[] = {0x20,   0x17F,  0x370,  0x3FF,  0x2010, 0x2027,
                                         0x2070, 0x209F, 0x2190, 0x22FF, 0};
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    std::error_code none;
    if (std::filesystem::exists(file, none)) {
        if (ImFont* font = fonts.AddFontFromFileTTF(file, pixels, nullptr, ranges)) return font;
    }
    ImFontConfig config;
    config.SizePixels = pixels;
    return fonts.AddFontDefault(&config);
}

ImVec4 colour(unsigned rgb, float alpha = 1) {
    return {static_cast<float>(rgb >> 16 & 0xFF) / 255, static_cast<float>(rgb >> 8 & 0xFF) / 255,
            static_cast<float>(rgb & 0xFF) / 255, alpha};
}

void set_surface_colours(ImVec4* colours) {
    colours[ImGuiCol_Text] = colour(0xE3E6EB);
    colours[ImGuiCol_TextDisabled] = colour(0x808894);
    colours[ImGuiCol_WindowBg] = colour(0x1B1E24);
    colours[ImGuiCol_ChildBg] = colour(0x1B1E24, 0);
    colours[ImGuiCol_PopupBg] = colour(0x22262E, 0.98f);
    colours[ImGuiCol_Border] = colour(0x343A45);
    colours[ImGuiCol_FrameBg] = colour(0x2A2F38);
    colours[ImGuiCol_FrameBgHovered] = colour(0x343B47);
    colours[ImGuiCol_FrameBgActive] = colour(0x3C4553);
    colours[ImGuiCol_TitleBg] = colour(0x16181D);
    colours[ImGuiCol_TitleBgActive] = colour(0x1F2A35);
    colours[ImGuiCol_MenuBarBg] = colour(0x16181D);
    colours[ImGuiCol_ScrollbarBg] = colour(0x1B1E24, 0.5f);
    colours[ImGuiCol_ScrollbarGrab] = colour(0x3C4350);
    colours[ImGuiCol_ScrollbarGrabHovered] = colour(0x4A5363);
    colours[ImGuiCol_ScrollbarGrabActive] = colour(0x5A6577);
    colours[ImGuiCol_Separator] = colour(0x343A45);
    colours[ImGuiCol_TableHeaderBg] = colour(0x22262E);
    colours[ImGuiCol_TableBorderLight] = colour(0x2B303A);
    colours[ImGuiCol_ModalWindowDimBg] = colour(0x000000, 0.45f);
}

void set_accent_colours(ImVec4* colours) {
    colours[ImGuiCol_CheckMark] = colour(0x4FB6C4);
    colours[ImGuiCol_SliderGrab] = colour(0x3F97A5);
    colours[ImGuiCol_SliderGrabActive] = colour(0x56C3D2);
    colours[ImGuiCol_Button] = colour(0x2F3641);
    colours[ImGuiCol_ButtonHovered] = colour(0x34606B);
    colours[ImGuiCol_ButtonActive] = colour(0x3C7682);
    colours[ImGuiCol_Header] = colour(0x2B3A44);
    colours[ImGuiCol_HeaderHovered] = colour(0x324B57);
    colours[ImGuiCol_HeaderActive] = colour(0x385A67);
    colours[ImGuiCol_Tab] = colour(0x22262E);
    colours[ImGuiCol_TabHovered] = colour(0x386572);
    colours[ImGuiCol_TabActive] = colour(0x2E4C57);
    colours[ImGuiCol_SeparatorHovered] = colour(0x3F97A5);
    colours[ImGuiCol_SeparatorActive] = colour(0x56C3D2);
    colours[ImGuiCol_TextSelectedBg] = colour(0x2F7B88, 0.55f);
    colours[ImGuiCol_NavHighlight] = colour(0x4FB6C4);
    colours[ImGuiCol_PlotHistogram] = colour(0x4FB6C4);
}

ImGuiStyle style_for(float scale) {
    ImGuiStyle style;
    ImGui::StyleColorsDark(&style);
    set_surface_colours(style.Colors);
    set_accent_colours(style.Colors);
    style.WindowPadding = {10, 8};
    style.FramePadding = {7, 4};
    style.ItemSpacing = {8, 6};
    style.ItemInnerSpacing = {6, 4};
    style.IndentSpacing = 14;
    style.ScrollbarSize = 11;
    style.GrabMinSize = 11;
    style.WindowRounding = 6;
    style.ChildRounding = 4;
    style.FrameRounding = 4;
    style.PopupRounding = 6;
    style.GrabRounding = 4;
    style.TabRounding = 4;
    style.ScrollbarRounding = 6;
    style.WindowBorderSize = 0;
    style.PopupBorderSize = 1;
    style.WindowTitleAlign = {0.5f, 0.5f};
    style.ScaleAllSizes(scale);
    return style;
}

}  // namespace

Gui::Gui(Window& window) : window_(window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.ConfigInputTextCursorBlink = true;
    ImGui_ImplGlfw_InitForOpenGL(window.handle(), false);
    ImGui_ImplOpenGL3_Init("#version 450");
    adapt();
}

Gui::~Gui() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Gui::begin() {
    if (window_.content_scale() != content_scale_) {
        adapt();
        ImGui_ImplOpenGL3_DestroyFontsTexture();
        ImGui_ImplOpenGL3_CreateFontsTexture();
    }
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
}

void Gui::draw() {
    const render::Gl& gl = window_.context().gl();
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.Viewport(0, 0, window_.framebuffer_width(), window_.framebuffer_height());
    gl.Disable(GL_SCISSOR_TEST);
    gl.ClearColor(0.07f, 0.08f, 0.09f, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Gui::adapt() {
    content_scale_ = window_.content_scale();
    scale_ = content_scale_ / window_.pixel_ratio();
    load_fonts(content_scale_);
    ImGui::GetIO().FontGlobalScale = scale_ / content_scale_;
    ImGui::GetStyle() = style_for(scale_);
}

void Gui::load_fonts(float scale) {
    ImGui::GetIO().Fonts->Clear();
    load_font(text_font, text_height * scale);
    monospaced_ = load_font(code_font, code_height * scale);
}

}  // namespace studio
