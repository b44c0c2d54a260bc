#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// Where the energy goes while the creature moves, and whether its physics can be believed.
class EnergyTab final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

}  // namespace cambrian
