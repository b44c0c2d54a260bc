#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// Sets how the next grid is bred: its size, the amount of mutation, the weight of fitness. Also
// offers help by automatic evolution and the return to it.
class PickingPanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

}  // namespace cambrian
