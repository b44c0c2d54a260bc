#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// Plots the energy balance of the moving creature and shows the verdict of the energy audit.
class EnergyTab final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

}  // namespace cambrian
