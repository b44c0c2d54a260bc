#pragma once

#include "studio/frame/panel.h"
#include "studio/panels/generations/timeline_chart.h"

namespace cambrian {

// Plots a quantity over the generations, with marks where settings changed and the values under the
// mouse. A click, a drag or the arrow keys display past champions.
class TimelinePanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    void follow_mouse(const PlotScale& scale, const FrameContext& frame, Requests& out) const;
    void follow_keys(const FrameContext& frame, Requests& out) const;

    TimelineChart chart_;
};

}  // namespace cambrian
