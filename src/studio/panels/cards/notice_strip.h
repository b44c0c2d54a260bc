#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// One quiet line at the viewport's foot: what was done, or what went wrong and what to do next.
class NoticeStrip final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

}  // namespace cambrian
