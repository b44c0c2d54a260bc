#pragma once

#include "studio/frame/panel.h"

#include <string>

namespace cambrian {

// Shows the help pages, with their list at the left.
class HelpPanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    std::string seen_;  // name of the page drawn last
};

}  // namespace cambrian
