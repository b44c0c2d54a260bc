#pragma once

#include "studio/frame/frame_context.h"
#include "studio/frame/requests.h"

namespace cambrian {

// A part of the window. Sees const data, answers with requests; drawn inside a window of its own
// that the layout placed.
class Panel {
public:
    virtual ~Panel() = default;
    virtual void draw(const FrameContext& frame, Requests& out) = 0;
};

}  // namespace cambrian
