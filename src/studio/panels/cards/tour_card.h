#pragma once

#include "studio/frame/panel.h"
#include "studio/look/ui_context.h"

namespace cambrian {

// One step of the tour: its title, its words, and where to go from it.
class TourCard final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

// Where the card of a step belongs: beside the place it is about, inside the window.
Rect tour_card_place(const Rect& subject, const Rect& window);
// The rectangle of the step's card in this frame; outlines the place it is about.
Rect tour_place(const FrameContext& frame, const CardSpace& space);

}  // namespace cambrian
