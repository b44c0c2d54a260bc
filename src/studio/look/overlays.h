#pragma once

// The overlays that can be drawn over the displayed creature, for the menus and the stored state.

#include "pictures/scene/worlds.h"
#include "studio/look/view_state.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace cambrian {

struct OverlayKind {
    const char* name;   // name in the stored state
    const char* label;  // "Joint limits"
    const char* help;
    bool OverlaysShown::*shown;
};

std::span<const OverlayKind> overlay_kinds();

// Names of Scenery, in its order, in the stored state and on the command line.
inline constexpr std::array kSceneryNames = {"automatic", "full", "light", "plain"};
std::optional<Scenery> scenery_named(std::string_view name);

// Returns the world that is shown for an environment with so much scenery; null if none is.
const DrawnWorld* shown_world(const ViewState& view, Scenery scenery,
                              const Environment& environment);
constexpr Detail detail_of(Scenery scenery) {
    return scenery == Scenery::kLight || scenery == Scenery::kPlain ? Detail::kLight
                                                                    : Detail::kFull;
}

}  // namespace cambrian
