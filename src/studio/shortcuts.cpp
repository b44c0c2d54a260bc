#include "studio/shortcuts.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>

namespace cambrian {
namespace {

template <class Action>
void simply(const FrameContext&, Requests& out) {
    out.ask(Action{});
}

void toggle_follow(const FrameContext& frame, Requests& out) {
    ViewState view = frame.view;
    view.follow = !view.follow;
    out.ask(ChangeView{view});
}

void faster(const FrameContext& frame, Requests& out) {
    ViewState view = frame.view;
    for (const double speed : kPlaybackSpeeds) {
        if (speed > view.speed) {
            view.speed = speed;
            break;
        }
    }
    out.ask(ChangeView{view});
}

void slower(const FrameContext& frame, Requests& out) {
    ViewState view = frame.view;
    for (const double speed : kPlaybackSpeeds) {
        if (speed < frame.view.speed) view.speed = speed;
    }
    out.ask(ChangeView{view});
}

void open_file(const FrameContext&, Requests& out) {
    out.ask(OpenFilePanel{FileTask::kOpen});
}

void save_creature(const FrameContext&, Requests& out) {
    out.ask(OpenFilePanel{FileTask::kSaveCreature});
}

void save_settings(const FrameContext&, Requests& out) {
    out.ask(OpenFilePanel{FileTask::kSaveSettings});
}

void close_what_is_open(const FrameContext& frame, Requests& out) {
    if (frame.files.open) {
        out.ask(CloseFilePanel{});
    } else if (frame.help_shown) {
        out.ask(ToggleHelp{});
    } else {
        out.ask(DismissNotice{});
    }
}

constexpr std::array kShortcuts = {
    Shortcut{{GLFW_KEY_SPACE}, "Space", "Evolve or pause", simply<ToggleEvolution>},
    Shortcut{{GLFW_KEY_G}, "G", "Evolve one generation", simply<RunOneGeneration>},
    Shortcut{{GLFW_KEY_P}, "P", "Play or pause the creature on show", simply<TogglePlayback>},
    Shortcut{{GLFW_KEY_R}, "R", "Restart the creature on show", simply<RestartPlayback>},
    Shortcut{{GLFW_KEY_PERIOD}, ".", "Play one tick", simply<StepPlayback>},
    Shortcut{{GLFW_KEY_LEFT_BRACKET}, "[", "Play slower", slower},
    Shortcut{{GLFW_KEY_RIGHT_BRACKET}, "]", "Play faster", faster},
    Shortcut{{GLFW_KEY_F}, "F", "Follow with the camera, or let go", toggle_follow},
    Shortcut{{GLFW_KEY_HOME}, "Home", "Fit the creature into view", simply<FitView>},
    Shortcut{{GLFW_KEY_N}, "N", "Show the newest champion", simply<ShowNewest>},
    Shortcut{{GLFW_KEY_O, true}, "Ctrl+O", "Open a creature or settings", open_file},
    Shortcut{{GLFW_KEY_S, true}, "Ctrl+S", "Save the creature on show", save_creature},
    Shortcut{{GLFW_KEY_S, true, true}, "Ctrl+Shift+S", "Save the settings", save_settings},
    Shortcut{{GLFW_KEY_Z, true}, "Ctrl+Z", "Undo an edit of genes or settings", simply<UndoEdit>},
    Shortcut{{GLFW_KEY_Z, true, true}, "Ctrl+Shift+Z", "Redo it", simply<RedoEdit>},
    Shortcut{{GLFW_KEY_F12}, "F12", "Keep a picture of the window", simply<SaveScreenshot>},
    Shortcut{{GLFW_KEY_F1}, "F1", "Help", simply<ToggleHelp>},
    Shortcut{{GLFW_KEY_ESCAPE}, "Esc", "Close what is open", close_what_is_open},
    Shortcut{{GLFW_KEY_Q, true}, "Ctrl+Q", "Quit", simply<QuitStudio>},
};

}  // namespace

std::span<const Shortcut> shortcuts() {
    return kShortcuts;
}

void press_shortcut(const KeyPress& press, bool typing, const FrameContext& frame, Requests& out) {
    if (typing && !press.control && press.key != GLFW_KEY_ESCAPE) return;
    const auto found = std::find_if(kShortcuts.begin(), kShortcuts.end(),
                                    [&press](const Shortcut& each) { return each.press == press; });
    if (found != kShortcuts.end()) found->ask(frame, out);
}

}  // namespace cambrian
