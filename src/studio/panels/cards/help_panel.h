#pragma once

#include "studio/frame/panel.h"

#include <string>

namespace cambrian {

// The pages of the help, their list to the left.
class HelpPanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    std::string seen_;  // the page drawn last
};

}  // namespace cambrian
