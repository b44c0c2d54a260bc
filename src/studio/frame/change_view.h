#pragma once

#include "studio/frame/frame_context.h"

namespace cambrian {

// Asks for the present view after `change(ViewState&)`.
template <class Change>
void change_view(const FrameContext& frame, Requests& out, const Change& change) {
    ViewState view = frame.view;
    change(view);
    out.ask(ChangeView{view});
}

}  // namespace cambrian
