#include "studio/window_controller.h"

#include <variant>

namespace cambrian {

// Has one overload for each kind of request.
struct WindowController::Handler {
    WindowController& self;

    void operator()(const ChangeView& request) const { self.view_ = request.view; }
    void operator()(const FocusPlace& request) const { self.facts_.focus = request.place; }
    void operator()(const TogglePalette&) const {
        self.facts_.palette_open = !self.facts_.palette_open;
    }
    void operator()(const DismissNotice&) const { self.feedback_.dismiss(); }
    void operator()(const QuitStudio&) const { self.quit_wanted_ = true; }
    void operator()(const ToggleFullScreen&) const {
        self.facts_.full_screen = !self.facts_.full_screen;
    }
    void operator()(const TogglePresentation&) const { self.present(!self.facts_.presenting); }
};

void WindowController::present(bool on) {
    if (on == facts_.presenting) return;
    facts_.presenting = on;
    facts_.palette_open = false;
    if (on) filled_before_ = facts_.full_screen;
    facts_.full_screen = on || filled_before_;
}

void WindowController::carry_out(const WindowRequest& request) {
    std::visit(Handler{*this}, request);
}

WindowView WindowController::facts() const {
    WindowView facts = facts_;
    facts.notice = feedback_.notice();
    return facts;
}

}  // namespace cambrian
