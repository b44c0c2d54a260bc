#pragma once

// The theme of the studio: fonts, sizes and colours for Dear ImGui. Sizes are in units of 1/96 inch
// and scale with the display.

#include "pictures/canvas/palette.h"

#include <imgui.h>

#include <string>

namespace cambrian {

struct Fonts {
    ImFont* body = nullptr;    // size 15
    ImFont* small = nullptr;   // size 13
    ImFont* strong = nullptr;  // size 15, semi-bold
    ImFont* title = nullptr;   // size 20, semi-bold
    ImFont* mono = nullptr;    // size 14, for typed text
};

// Sets the colours and spacing of Dear ImGui's own controls.
void apply_style(const Palette& palette, float scale);

// Returns how typefaces are rasterised.
ImFontConfig face_config();
// Adds the studio's typeface to the font atlas: Inter or, without it, another installed one.
Fonts load_fonts(float scale);

}  // namespace cambrian
