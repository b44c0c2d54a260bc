#include "studio/look/theme.h"

#include "pictures/canvas/typefaces.h"

#include <array>
#include <filesystem>

namespace cambrian {
namespace {

// Glyph ranges: Latin, Greek, general punctuation, superscripts, arrows, mathematical operators.
constexpr std::array<ImWchar, 13> kGlyphs = {0x20,   0x24F,  0x370,  0x3FF,  0x2010, 0x2027, 0x2070,
                                             0x209F, 0x2190, 0x21FF, 0x2200, 0x22FF, 0};

}  // namespace

ImFontConfig face_config() {
    ImFontConfig config;
    config.OversampleH = 2;
    config.OversampleV = 1;
    config.PixelSnapH = true;
    return config;
}

namespace {

ImFont* add_face(Typeface typeface, float size) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    ImFontConfig config = face_config();
    for (const std::filesystem::path& file : installed_files(typeface)) {
        if (ImFont* font = atlas.AddFontFromFileTTF(file.c_str(), size, &config, kGlyphs.data())) {
            return font;
        }
    }
    config.SizePixels = size;
    return atlas.AddFontDefault(&config);
}

ImVec4 vec(const Color& color) {
    return {color.r, color.g, color.b, color.a};
}

void apply_colors(const Palette& p, ImGuiStyle& style) {
    const auto set = [&style](ImGuiCol slot, const Color& color) {
        style.Colors[slot] = vec(color);
    };
    set(ImGuiCol_Text, p.text);
    set(ImGuiCol_TextDisabled, p.muted);
    set(ImGuiCol_WindowBg, p.panel);
    set(ImGuiCol_ChildBg, with_alpha(p.panel, 0.0F));
    set(ImGuiCol_PopupBg, p.overlay);
    set(ImGuiCol_Border, p.border);
    set(ImGuiCol_FrameBg, p.raised);
    set(ImGuiCol_FrameBgHovered, p.hovered);
    set(ImGuiCol_FrameBgActive, p.hovered);
    set(ImGuiCol_ScrollbarBg, with_alpha(p.panel, 0.0F));
    set(ImGuiCol_ScrollbarGrab, p.raised);
    set(ImGuiCol_ScrollbarGrabHovered, p.hovered);
    set(ImGuiCol_ScrollbarGrabActive, p.faint);
    set(ImGuiCol_CheckMark, p.accent);
    set(ImGuiCol_SliderGrab, p.accent);
    set(ImGuiCol_SliderGrabActive, p.accent);
    set(ImGuiCol_Button, p.raised);
    set(ImGuiCol_ButtonHovered, p.hovered);
    set(ImGuiCol_ButtonActive, p.hovered);
    set(ImGuiCol_Header, with_alpha(p.accent, 0.25F));
    set(ImGuiCol_HeaderHovered, p.hovered);
    set(ImGuiCol_HeaderActive, p.hovered);
    set(ImGuiCol_Separator, p.border);
    set(ImGuiCol_TableBorderLight, p.border);
    set(ImGuiCol_TableBorderStrong, p.border);
    set(ImGuiCol_TextSelectedBg, with_alpha(p.accent, 0.35F));
    set(ImGuiCol_NavHighlight, p.accent);
}

}  // namespace

void apply_style(const Palette& palette, float scale) {
    ImGuiStyle style;
    style.WindowPadding = {14, 12};
    style.FramePadding = {10, 5};
    style.ItemSpacing = {8, 8};
    style.ItemInnerSpacing = {8, 6};
    style.ScrollbarSize = 10;
    style.GrabMinSize = 1;
    style.WindowBorderSize = 0;
    style.ChildBorderSize = 0;
    style.PopupBorderSize = 1;
    style.FrameBorderSize = 0;
    style.WindowRounding = 0;
    style.ChildRounding = 6;
    style.FrameRounding = 5;
    style.PopupRounding = 8;
    style.ScrollbarRounding = 5;
    style.GrabRounding = 5;
    style.ScaleAllSizes(scale);
    apply_colors(palette, style);
    ImGui::GetStyle() = style;
}

Fonts load_fonts(float scale) {
    Fonts fonts;
    fonts.body = add_face(Typeface::kRegular, 15.0F * scale);
    fonts.small = add_face(Typeface::kRegular, 13.0F * scale);
    fonts.strong = add_face(Typeface::kStrong, 15.0F * scale);
    fonts.title = add_face(Typeface::kStrong, 20.0F * scale);
    fonts.mono = add_face(Typeface::kMono, 14.0F * scale);
    return fonts;
}

}  // namespace cambrian
