#pragma once

#include "render/color.h"
#include "studio/look/ui_context.h"

namespace cambrian {

// Clears an area of the bound framebuffer, in pixels of the display, and paints the draw lists
// inside it. Nothing outside the area changes. A draw list with a callback must lie entirely inside
// or outside the area. Needs Dear ImGui's OpenGL backend.
void paint_area(const ImDrawData& data, const Rect& area, const Color& background);

}  // namespace cambrian
