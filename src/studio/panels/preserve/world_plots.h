#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// The plot of one of the quantities of the series over the preserve's time.
class WorldPlotsPanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

// The pools of energy over the preserve's time, one on top of the other.
class EnergyPlotPanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

}  // namespace cambrian
