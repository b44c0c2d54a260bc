#pragma once

#include "studio/frame/panel.h"
#include "studio/panels/cards/samples_panel.h"

namespace cambrian {

// Shows the runs that were used lately, each with its newest champion, and the samples below them.
class StartPanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    SamplesPanel samples_;
};

}  // namespace cambrian
