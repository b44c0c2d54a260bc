#pragma once

// The overlays that can be drawn over the displayed creature, for the menus and the stored state.

#include "studio/look/view_state.h"

#include <span>

namespace cambrian {

struct OverlayKind {
    const char* name;   // name in the stored state
    const char* label;  // "Joint limits"
    const char* help;
    bool OverlaysShown::*shown;
};

std::span<const OverlayKind> overlay_kinds();

}  // namespace cambrian
