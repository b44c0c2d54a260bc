#pragma once

// Text on the screen that cannot be read: cut by the edge of its window, or written over other
// text. Found among the letters that Dear ImGui is about to draw, whatever drew them.

#include "studio/look/ui_context.h"

#include <string>
#include <vector>

namespace cambrian {

enum class TextFaultKind : unsigned char { kCut, kOverlap };

struct TextFault {
    TextFaultKind kind = TextFaultKind::kCut;
    std::string window;  // Dear ImGui's name of the window that it stands in
    std::string text;    // of the line, as much of it as is drawn
    std::string other;   // written over it; empty for cut text
    Rect where;          // of the line, in window pixels
};

// In the frame that was rendered last. What scrolling brings into sight is not cut.
std::vector<TextFault> find_text_faults();

}  // namespace cambrian
