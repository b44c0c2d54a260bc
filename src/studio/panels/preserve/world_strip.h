#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// The controls under the world: play and speed, food, camera.
class WorldStrip final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

}  // namespace cambrian
