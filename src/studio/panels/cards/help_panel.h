#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// Shows the help pages, with their list at the left.
class HelpPanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    unsigned asked_ = 0;  // the count of ShowHelp requests in the last frame
};

}  // namespace cambrian
