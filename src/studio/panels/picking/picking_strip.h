#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// Under the grid: through the tree, what can be done with the creature in focus, what is shown.
class PickingStrip final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

}  // namespace cambrian
