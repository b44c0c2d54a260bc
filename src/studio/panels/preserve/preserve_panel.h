#pragma once

#include "studio/frame/panel.h"
#include "studio/panels/preserve/law_list.h"
#include "studio/panels/preserve/museum_list.h"

namespace cambrian {

// The left panel of a preserve: what can be added to it, its file, and one of the lists about it.
class PreservePanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    LawList laws_;
    MuseumList museum_;
};

}  // namespace cambrian
