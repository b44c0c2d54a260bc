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
// Outlines the place over everything else.
void outline_subject(const Rect& subject);

}  // namespace cambrian
