#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// The strip under the grid: steps through the tree, commands on the focused creature, display
// options.
class PickingStrip final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

}  // namespace cambrian
