#pragma once

// The theme of the studio: fonts, sizes and colours for Dear ImGui. Sizes are in units of 1/96 inch
// and scale with the display.

#include "pictures/canvas/palette.h"

#include <imgui.h>

#include <string>

namespace cambrian {

struct Fonts {
    ImFont* body = nullptr;    // 15
    ImFont* small = nullptr;   // 13
    ImFont* strong = nullptr;  // 15, semi-bold
    ImFont* title = nullptr;   // 20, semi-bold
    ImFont* mono = nullptr;    // 14, for what is typed
};

// Colours and spacing of Dear ImGui's own controls.
void apply_style(const Palette& palette, float scale);

// Adds the studio's typeface (Inter, or what is installed) to the font atlas.
Fonts load_fonts(float scale);

}  // namespace cambrian
