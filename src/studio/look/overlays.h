#pragma once

// The overlays that can be drawn over the displayed creature, for the menus and the stored state.

#include "pictures/scene/worlds.h"
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

// Returns the world that the scenery shows for an environment; null if none is shown.
const DrawnWorld* shown_world(const ViewState& view, const Environment& environment);

}  // namespace cambrian
