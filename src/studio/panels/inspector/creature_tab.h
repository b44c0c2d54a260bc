#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// Numbers of the creature on show: its fitness and how it was made up, its body, where it comes
// from, the audit of its trial.
class CreatureTab final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

}  // namespace cambrian
