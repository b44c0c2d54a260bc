// The creature on display and its playback.

#include "studio/actions/subjects.h"

namespace cambrian {
namespace {

template <int Steps>
void change_speed(const FrameContext& frame, Requests& out) {
    const auto count = static_cast<int>(kPlaybackSpeeds.size());
    int next = Steps > 0 ? count - 1 : 0;
    for (int i = 0; i < count; ++i) {
        const int at = Steps > 0 ? count - 1 - i : i;
        const double speed = kPlaybackSpeeds[static_cast<std::size_t>(at)];
        if (Steps > 0 ? speed > frame.view.speed : speed < frame.view.speed) next = at;
    }
    change_view(frame, out, [next](ViewState& view) {
        view.speed = kPlaybackSpeeds[static_cast<std::size_t>(next)];
    });
}

bool is_shown(const FrameContext& frame) {
    return !frame.viewer.playback.empty();
}

bool has_trials(const FrameContext& frame) {
    return is_shown(frame) && frame.viewer.playback.exhibit().settings().world.trial.trials > 1;
}
bool draws_ground(const FrameContext& frame) {
    return frame.viewer.ground_pen || frame.may_draw_ground();
}
bool may_draw(const FrameContext& frame) {
    return frame.may_draw_creature();
}
bool draws_creature(const FrameContext& frame) {
    return frame.drawing();
}
void draw_creature(const FrameContext& frame, Requests& out) {
    if (frame.may_draw_creature()) out.ask(ToggleDrawing{});
}
void draw_new_creature(const FrameContext& frame, Requests& out) {
    if (frame.may_draw_creature()) out.ask(DrawNewCreature{});
}
bool holds_pen(const FrameContext& frame) {
    return frame.viewer.ground_pen;
}

}  // namespace

std::vector<Action> creature_actions() {
    using enum FileTask;
    // clang-format off
    return {
        {"play", "P", "Play or pause the creature on display", asks<TogglePlayback{}>, {}, {}, "", true},
        {"restart", "R", "Restart the creature on display", asks<RestartPlayback{}>, {}, {}, "", true},
        {"tick", ".", "Play one tick", asks<StepPlayback{}>, {}, {}, "", true},
        {"tick-back", ",", "Go back one tick", asks<StepPlaybackBack{}>, {}, {}, "", true},
        {"trial-next", "Shift+.", "Next trial of the creature on display", asks<TurnTrial{1}>, has_trials, {}, "Of the trials that its score combines.", true},
        {"trial-before", "Shift+,", "The trial before", asks<TurnTrial{-1}>, has_trials, {}, "", true},
        {"slower", "[", "Play slower", change_speed<-1>, {}, {}, "", true},
        {"faster", "]", "Play faster", change_speed<1>, {}, {}, "", true},
        {"follow", "F", "Follow the creature", toggles<&ViewState::follow>, {}, is_on<&ViewState::follow>, "The camera goes with it, or stays.", true},
        {"fit", "Home", "Fit into view", asks<FitView{}>, {}, {}, "The creature on display fills the viewport.", true},
        {"draw-ground", "D", "Draw ground", asks<ToggleGroundPen{}>, draws_ground, holds_pen, "Each line that is dragged in the viewport becomes the ground between its ends."},
        {"draw-creature", "Shift+D", "Draw this creature", draw_creature, may_draw, draws_creature, "Parts are added and changed with the mouse, on paper; each stroke can be undone."},
        {"draw-new", "", "Draw a new creature", draw_new_creature, may_draw, {}, "It begins as one part."},
        {"side-front", "Keypad 1", "From the front", asks<LookFrom{ViewSide::kFront}>, in_space, {}, "In three dimensions; along the z axis.", true},
        {"side-right", "Keypad 3", "From the right", asks<LookFrom{ViewSide::kRight}>, in_space, {}, "In three dimensions; along the x axis.", true},
        {"side-top", "Keypad 7", "From above", asks<LookFrom{ViewSide::kTop}>, in_space, {}, "In three dimensions; along the y axis.", true},
        {"side-slanted", "Keypad 5", "From the side and above", asks<LookFrom{}>, in_space, {}, "In three dimensions; as at first.", true},
        {"newest", "N", "Show the newest champion", asks<ShowNewest{}>},
        {"newest-always", "", "Show each new champion", toggles<&ViewState::newest_champion>, {}, is_on<&ViewState::newest_champion>, "The best of each finished generation is displayed."},
        {"star", "K", "Star the creature on display", asks<ToggleStarOfShown{}>, is_shown, {}, "Or take its star away."},
        {"save-creature", "Ctrl+S", "Save creature…", asks<OpenFilePanel{kSaveCreature}>, is_shown, {}, "The one on display, in a file of its own or as a card."},
        {"evolve-shown", "", "New run from the creature on display", asks<StartFromShown{}>, is_shown},
    };
    // clang-format on
}

}  // namespace cambrian
