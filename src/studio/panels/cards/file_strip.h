#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// One line at the bottom of the viewport: the clip that is being written, and a button to stop.
class FileStrip final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

// Returns the strip's rectangle, above the notice if there is one.
Rect file_strip_place(const FrameContext& frame, const CardSpace& space);

}  // namespace cambrian
