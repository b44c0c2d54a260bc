#pragma once

// The actions of each subject, and what they are made of.

#include "studio/actions/action.h"
#include "studio/frame/change_view.h"

#include <vector>

namespace cambrian {

std::vector<Action> evolution_actions();
std::vector<Action> creature_actions();
std::vector<Action> file_actions();
std::vector<Action> view_actions();
std::vector<Action> help_actions();
std::vector<Action> picking_actions();
std::vector<Action> preserve_actions();
std::vector<Action> drawing_actions();

inline bool in_space(const FrameContext& frame) {
    return frame.in_space();
}

// Closes the topmost card; returns false if none is open.
bool close_card(const FrameContext& frame, Requests& out);

template <auto Request>
void asks(const FrameContext&, Requests& out) {
    out.ask(Request);
}

// Changes or reads a flag of the view, which is reached through these members.
template <auto... Members>
void toggles(const FrameContext& frame, Requests& out) {
    change_view(frame, out, [](ViewState& view) {
        bool& flag = (view.*....*Members);
        flag = !flag;
    });
}
template <auto... Members>
bool is_on(const FrameContext& frame) {
    return (frame.view.*....*Members);
}

}  // namespace cambrian
