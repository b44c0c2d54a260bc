#include "studio/theme.h"

#include <array>
#include <filesystem>

namespace cambrian {
namespace {

constexpr std::array kRegularFaces = {
    "/usr/share/fonts/opentype/inter/Inter-Regular.otf",
    "/usr/share/fonts/truetype/inter/Inter-Regular.ttf",
    "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Regular.ttf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
};
constexpr std::array kStrongFaces = {
    "/usr/share/fonts/opentype/inter/Inter-SemiBold.otf",
    "/usr/share/fonts/truetype/inter/Inter-SemiBold.ttf",
    "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Medium.ttf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf",
};
constexpr std::array kMonoFaces = {
    "/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationMono-Regular.ttf",
};
// Latin, general punctuation, superscripts, arrows, mathematical operators.
constexpr std::array<ImWchar, 13> kGlyphs = {0x20,   0x24F,  0x370,  0x3FF,  0x2010, 0x2027, 0x2070,
                                             0x209F, 0x2190, 0x21FF, 0x2200, 0x22FF, 0};

template <std::size_t Count>
ImFont* add_face(const std::array<const char*, Count>& faces, float size) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    ImFontConfig config;
    config.OversampleH = 2;
    config.OversampleV = 1;
    config.PixelSnapH = true;
    for (const char* face : faces) {
        std::error_code error;
        if (!std::filesystem::exists(face, error)) continue;
        if (ImFont* font = atlas.AddFontFromFileTTF(face, size, &config, kGlyphs.data())) {
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

Palette palette_of(ThemeKind kind) {
    Palette p;
    const bool dark = kind == ThemeKind::kDark;
    const auto choose = [dark](unsigned dark_rgb, unsigned light_rgb) {
        return color_of(dark ? dark_rgb : light_rgb);
    };
    p.window = choose(0x0F1216, 0xD9DDE2);
    p.panel = choose(0x171B21, 0xF4F5F7);
    p.raised = choose(0x242A33, 0xE3E6EB);
    p.hovered = choose(0x303844, 0xD5DAE1);
    p.overlay = choose(0x1E242C, 0xFDFDFE);
    p.border = choose(0x2A313B, 0xCDD2D9);
    p.text = choose(0xE6EAEF, 0x1C2127);
    p.muted = choose(0x98A3B1, 0x5A6573);
    p.faint = choose(0x566170, 0x98A2AE);
    p.accent = choose(0x45B8A4, 0x12806F);
    p.on_accent = choose(0x06231E, 0xFFFFFF);
    p.danger = choose(0xE8806A, 0xB23A22);
    p.sky = choose(0x12161B, 0xEBEEF2);
    p.ground = choose(0x1D232B, 0xD4D9DF);
    p.ground_line = choose(0x5B6878, 0x7F8A97);
    p.plot_best = choose(0xE69F00, 0xB87A00);
    p.plot_median = choose(0x56B4E9, 0x0072B2);
    return p;
}

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
    fonts.body = add_face(kRegularFaces, 15.0F * scale);
    fonts.small = add_face(kRegularFaces, 13.0F * scale);
    fonts.strong = add_face(kStrongFaces, 15.0F * scale);
    fonts.title = add_face(kStrongFaces, 20.0F * scale);
    fonts.mono = add_face(kMonoFaces, 14.0F * scale);
    return fonts;
}

}  // namespace cambrian
