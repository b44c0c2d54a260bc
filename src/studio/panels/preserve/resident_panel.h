#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// The life of the picked creature of a preserve.
class ResidentPanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

}  // namespace cambrian
