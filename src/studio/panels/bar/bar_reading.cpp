#include "studio/panels/bar/bar_reading.h"

#include "studio/look/ui_context.h"

#include <cmath>

namespace cambrian {

float draw_reading(const ImVec2& at, const std::string& value, const std::string& name) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    Fonts& fonts = ui().fonts;
    const float strong = 15.0F * ui().scale;
    const float small = 13.0F * ui().scale;
    list.AddText(fonts.strong, strong, at, paint(colors().text), value.c_str());
    list.AddText(fonts.small, small, {at.x, at.y + px(17)}, paint(colors().muted), name.c_str());
    const auto width = [](ImFont* font, float size, const std::string& text) {
        return font->CalcTextSizeA(size, INFINITY, 0.0F, text.c_str()).x;
    };
    return std::fmax(width(fonts.strong, strong, value), width(fonts.small, small, name));
}

}  // namespace cambrian
