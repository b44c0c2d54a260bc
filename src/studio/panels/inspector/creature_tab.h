#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// Shows numbers of the displayed creature: its fitness and how that is composed, its body, its
// origin.
class CreatureTab final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

}  // namespace cambrian
