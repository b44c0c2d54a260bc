#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// A line at the bottom of the window, shown while the user wants a cluster. It says how many
// machines evaluate and how fast, or why none does. A click opens the card of machines.
class MachinesLine final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

}  // namespace cambrian
