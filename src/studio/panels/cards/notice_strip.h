#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// One line at the bottom of the viewport: a task done, or an error and what to do next.
class NoticeStrip final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

// Returns the strip's rectangle at the bottom of the viewport, as large as its text needs.
Rect notice_place(const FrameContext& frame, const CardSpace& space);

}  // namespace cambrian
