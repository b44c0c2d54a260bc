#pragma once

// Owns what concerns the window itself: where the keyboard goes, and when the program ends.

#include "studio/background/feedback.h"
#include "studio/frame/window_contract.h"

namespace cambrian {

class WindowController {
public:
    // Both must outlive it.
    WindowController(Feedback& feedback, ViewState& view) : feedback_(feedback), view_(view) {}

    // Shows one creature and offers nothing else.
    void be_viewer() { facts_.viewer_only = true; }
    // Before a frame's requests: the keyboard is sent to a place only once.
    void clear_focus() { facts_.focus = Place::kNone; }
    void carry_out(const WindowRequest& request);
    WindowView facts() const;
    bool quit_wanted() const { return quit_wanted_; }

private:
    struct Handler;

    Feedback& feedback_;
    ViewState& view_;
    WindowView facts_;
    bool quit_wanted_ = false;
};

}  // namespace cambrian
