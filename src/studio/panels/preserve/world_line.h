#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// The line along the bottom: population, speed and energy of the preserve.
class WorldLine final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

}  // namespace cambrian
