#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// Says below the founders what they are, and offers others.
class FoundersStrip final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

}  // namespace cambrian
