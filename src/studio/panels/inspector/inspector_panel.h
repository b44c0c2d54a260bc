#pragma once

#include "studio/frame/panel.h"

#include <memory>
#include <string>
#include <vector>

namespace cambrian {

// Shows what is known of the displayed creature, in tabs.
class InspectorPanel final : public Panel {
public:
    InspectorPanel();
    void draw(const FrameContext& frame, Requests& out) override;

private:
    struct Tab {
        std::string title;
        std::unique_ptr<Panel> panel;
    };
    std::vector<Tab> tabs_;
    int chosen_ = 0;
};

}  // namespace cambrian
