#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// How the next grid is bred: its size, how much changes, how much fitness counts; help from
// automatic evolution; and the way back to it.
class PickingPanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

}  // namespace cambrian
