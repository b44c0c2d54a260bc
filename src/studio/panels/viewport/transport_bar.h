#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// The bar under the viewport: restart, play, single tick, speed, camera.
class TransportBar final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

}  // namespace cambrian
