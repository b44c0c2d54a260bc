#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// One line along the bottom while a cluster is wanted: how many machines evaluate and how fast, or
// why none does. A click opens the card of machines.
class MachinesLine final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

}  // namespace cambrian
