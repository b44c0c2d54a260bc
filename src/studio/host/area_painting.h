#pragma once

#include "render/color.h"
#include "studio/look/ui_context.h"

namespace cambrian {

// Clears an area of the bound framebuffer, in pixels of the display, and paints there what lies in
// it; nothing outside of it changes. A list that calls back must lie within it or outside. Needs
// Dear ImGui's OpenGL backend.
void paint_area(const ImDrawData& data, const Rect& area, const Color& background);

}  // namespace cambrian
