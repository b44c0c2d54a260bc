#pragma once

// The data of the window itself that panels see, and the requests they may make of it.

#include "studio/background/notices.h"
#include "studio/look/view_state.h"

#include <cstdint>
#include <variant>

namespace cambrian {

// The panels that the keyboard focus can be moved to.
enum class Place : std::uint8_t { kNone, kTimeline, kPopulation };

struct ChangeView {
    ViewState view;
};
struct FocusPlace {
    Place place = Place::kNone;
};
// Opens or closes the command palette.
struct TogglePalette {};
struct DismissNotice {};
struct QuitStudio {};
struct ToggleFullScreen {};
// Begins or ends the presentation of the best creatures.
struct TogglePresentation {};

using WindowRequest = std::variant<ChangeView, FocusPlace, TogglePalette, DismissNotice, QuitStudio,
                                   ToggleFullScreen, TogglePresentation>;

struct WindowView {
    const Notice* notice = nullptr;  // null if there is no notice
    Place focus = Place::kNone;      // panel that gets the keyboard focus in this frame
    bool palette_open = false;
    bool viewer_only = false;    // only the viewport and its transport bar are shown
    bool full_screen = false;    // the window fills the display
    bool presenting = false;     // only the viewport is shown, with large words
    int framebuffer_height = 0;  // pixels
    bool narrow = false;  // has no room for both side panels, so that the left one hides the other
    Scenery scenery = Scenery::kFull;  // that is drawn; never kAutomatic
};

}  // namespace cambrian
