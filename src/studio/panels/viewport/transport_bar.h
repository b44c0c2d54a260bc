#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// Under the viewport: restart, play, one tick, speed, camera.
class TransportBar final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

}  // namespace cambrian
