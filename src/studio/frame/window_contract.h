#pragma once

// What panels see of the window itself and what they may request of it.

#include "studio/background/notices.h"
#include "studio/look/view_state.h"

#include <cstdint>
#include <variant>

namespace cambrian {

// Places of the window that the keyboard can be sent to.
enum class Place : std::uint8_t { kNone, kTimeline, kPopulation };

struct ChangeView {
    ViewState view;
};
struct FocusPlace {
    Place place = Place::kNone;
};
struct DismissNotice {};
struct QuitStudio {};

using WindowRequest = std::variant<ChangeView, FocusPlace, DismissNotice, QuitStudio>;

struct WindowView {
    const Notice* notice = nullptr;  // null where there is none
    Place focus = Place::kNone;      // gets the keyboard in this frame
    bool viewer_only = false;        // the viewport and its transport alone
    int framebuffer_height = 0;      // pixels
};

}  // namespace cambrian
