#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// One line at the bottom of the viewport: what was done, or an error and what to do next.
class NoticeStrip final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

// The strip's rectangle: as wide and high as its words need, at the viewport's foot.
Rect notice_place(const FrameContext& frame, const CardSpace& space);

}  // namespace cambrian
