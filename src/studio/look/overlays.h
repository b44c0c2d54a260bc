#pragma once

// What may be laid over the creature on show: one list for the menus and for what is remembered.

#include "studio/look/view_state.h"

#include <span>

namespace cambrian {

struct OverlayKind {
    const char* name;   // as remembered
    const char* label;  // "Joint limits"
    const char* help;
    bool OverlaysShown::*shown;
};

std::span<const OverlayKind> overlay_kinds();

}  // namespace cambrian
