#pragma once

#include "studio/panel.h"

namespace cambrian {

// First steps and the table of keys.
class HelpPanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
};

}  // namespace cambrian
