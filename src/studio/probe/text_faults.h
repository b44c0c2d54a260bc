#pragma once

// Finds text on the screen that cannot be read: cut by the edge of its window, or overlapped by
// other text. It searches the glyphs that Dear ImGui is about to draw.

#include "studio/look/ui_context.h"

#include <string>
#include <vector>

namespace cambrian {

enum class TextFaultKind : unsigned char { kCut, kOverlap };

struct TextFault {
    TextFaultKind kind = TextFaultKind::kCut;
    std::string window;  // Dear ImGui's name of its window
    std::string text;    // the line of text, as far as it is drawn
    std::string other;   // overlapping text; empty for cut text
    Rect where;          // rectangle of the line, in window pixels
};

// Returns the faults of the frame that was rendered last. Text that scrolling can bring into sight
// does not count as cut.
std::vector<TextFault> find_text_faults();

}  // namespace cambrian
