#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// Says that the best fitness no longer rises and offers what can be changed, in one click each.
class SuggestionsCard final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

// Returns the card's rectangle, at the right of the viewport.
Rect suggestions_place(const FrameContext& frame, const CardSpace& space);

}  // namespace cambrian
