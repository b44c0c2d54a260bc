#pragma once

// Owns what concerns the window itself: the keyboard focus, and the end of the program.

#include "studio/background/feedback.h"
#include "studio/frame/window_contract.h"

namespace cambrian {

class WindowController {
public:
    // Both references must outlive the controller.
    WindowController(Feedback& feedback, ViewState& view) : feedback_(feedback), view_(view) {}

    // Displays one creature and offers no evolution.
    void be_viewer() { facts_.viewer_only = true; }
    // Must be called before a frame's requests, since a move of the focus lasts one frame.
    void clear_focus() { facts_.focus = Place::kNone; }
    void carry_out(const WindowRequest& request);
    WindowView facts() const;
    // Shows only the viewport, on all of the display, or ends that.
    void present(bool on);
    bool quit_wanted() const { return quit_wanted_; }

private:
    struct Handler;

    Feedback& feedback_;
    ViewState& view_;
    WindowView facts_;
    bool filled_before_ = false;  // whether the window filled the display before it presented
    bool quit_wanted_ = false;
};

}  // namespace cambrian
