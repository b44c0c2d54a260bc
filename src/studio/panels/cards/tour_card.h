#pragma once

#include "studio/frame/panel.h"
#include "studio/look/ui_context.h"

namespace cambrian {

// Shows one step of the tour: its title, its text and the buttons to other steps.
class TourCard final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

// Returns the rectangle of a step's card: beside its subject, inside the window.
Rect tour_card_place(const Rect& subject, const Rect& window);
// Returns the rectangle of the present step's card, and outlines the step's subject.
Rect tour_place(const FrameContext& frame, const CardSpace& space);

}  // namespace cambrian
