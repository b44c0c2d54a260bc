#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// The left panel of a preserve: what can be added to it, its file, its lineages.
class PreservePanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

}  // namespace cambrian
