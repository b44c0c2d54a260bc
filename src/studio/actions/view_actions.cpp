// Actions that change what the window shows and how.

#include "studio/actions/subjects.h"
#include "studio/look/overlays.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace cambrian {
namespace {

struct ViewLine {
    const char* id;
    const char* label;
    const char* help;
};
// In the order of LookMode, Scenery and GhostChoice.
constexpr std::array kLookLines = {
    ViewLine{"look-life", "Life", "Creatures in their skin, with the pattern of their founder."},
    ViewLine{"look-glass", "Glass", "Their boxes and joints through a pale skin."},
    ViewLine{"look-mechanics", "Mechanics", "The boxes and joints that physics moves."},
};
constexpr std::array kSceneryLines = {
    ViewLine{"scenery-automatic", "Automatic scenery", "As much of it as can be drawn smoothly."},
    ViewLine{"scenery-full", "Full scenery",
             "The place that the environment is: meadow, ice, Moon, water, air, or night around a "
             "lamp. It is plain behind creatures that are seen as mechanics."},
    ViewLine{"scenery-light", "Light scenery",
             "The same with less grass, fewer bubbles and simpler light."},
    ViewLine{"scenery-plain", "Plain background", "No scenery."},
};
constexpr std::array kGhostLines = {
    ViewLine{"ghosts-none", "No ghosts", "The creature on display is alone."},
    ViewLine{"ghosts-improvements", "Last three improvements",
             "The last three champions that were fitter than all before them."},
    ViewLine{"ghosts-tenths", "Every tenth generation",
             "The champions of the last six generations 0, 10, 20..."},
    ViewLine{"ghosts-across", "Five across the run",
             "From the first champion to the newest, evenly spaced."},
};

// Adds an action for each value of a member of the view.
template <auto Member, std::size_t Count>
void add_choices(std::vector<Action>& actions, const std::array<ViewLine, Count>& lines) {
    for (std::size_t i = 0; i < Count; ++i) {
        using Value = std::remove_reference_t<decltype(std::declval<ViewState&>().*Member)>;
        const auto value = static_cast<Value>(i);
        Action action{lines[i].id, "", lines[i].label, [value](const auto& frame, Requests& out) {
                          change_view(frame, out,
                                      [value](ViewState& view) { view.*Member = value; });
                      }};
        action.chosen = [value](const FrameContext& frame) { return frame.view.*Member == value; };
        action.help = lines[i].help;
        actions.push_back(std::move(action));
    }
}

void add_overlays(std::vector<Action>& actions) {
    for (const OverlayKind& overlay : overlay_kinds()) {
        const auto shown = overlay.shown;
        Action action{std::string("overlay-") + overlay.name, "", overlay.label,
                      [shown](const FrameContext& frame, Requests& out) {
                          change_view(frame, out, [shown](ViewState& view) {
                              view.overlays.*shown = !(view.overlays.*shown);
                          });
                      }};
        action.chosen = [shown](const FrameContext& frame) { return frame.view.overlays.*shown; };
        action.help = overlay.help;
        actions.push_back(std::move(action));
    }
}

void switch_theme(const FrameContext& frame, Requests& out) {
    change_view(frame, out, [](ViewState& view) {
        view.theme = view.theme == ThemeKind::kLight ? ThemeKind::kDark : ThemeKind::kLight;
    });
}
// If there is no room for both side panels, showing one hides the other.
template <auto Side, auto Other>
bool is_side_shown(const FrameContext& frame) {
    const PanelSizes& panels = frame.view.panels;
    const bool hidden = frame.window.narrow && panels.left && Side == &PanelSizes::right;
    return panels.*Side && !hidden;
}
template <auto Side, auto Other>
void switch_side(const FrameContext& frame, Requests& out) {
    change_view(frame, out, [&](ViewState& view) {
        view.panels.*Side = !is_side_shown<Side, Other>(frame);
        if (view.panels.*Side && frame.window.narrow) view.panels.*Other = false;
    });
}

void set_size(const FrameContext& frame, Requests& out, int size) {
    change_view(frame, out, [size](ViewState& view) { view.size = size; });
}
template <int Steps>
void change_size(const FrameContext& frame, Requests& out) {
    const auto* const found =
        std::find(kInterfaceSizes.begin(), kInterfaceSizes.end(), frame.view.size);
    const auto next = (found - kInterfaceSizes.begin()) + Steps;
    if (next >= 0 && next < static_cast<std::ptrdiff_t>(kInterfaceSizes.size()))
        set_size(frame, out, kInterfaceSizes[static_cast<std::size_t>(next)]);
}
void add_sizes(std::vector<Action>& actions) {
    for (const int size : kInterfaceSizes) {
        Action action{fmt::format("size-{}", size), size == 100 ? "Ctrl+0" : "",
                      fmt::format("Interface size: {} %", size),
                      [size](const auto& frame, Requests& out) { set_size(frame, out, size); }};
        action.chosen = [size](const FrameContext& frame) { return frame.view.size == size; };
        if (size == 100) action.help = "The size that the desktop tells.";
        actions.push_back(std::move(action));
    }
}

bool is_light(const FrameContext& frame) {
    return frame.view.theme == ThemeKind::kLight;
}

bool is_full_screen(const FrameContext& frame) {
    return frame.window.full_screen;
}
bool may_present(const FrameContext& frame) {
    return frame.preserve == nullptr && frame.picking == nullptr;
}

void switch_look(const FrameContext& frame, Requests& out) {
    change_view(frame, out, [](ViewState& view) { view.look = next_look(view.look); });
}

void close_what_is_open(const FrameContext& frame, Requests& out) {
    if (close_card(frame, out)) return;
    if (frame.window.notice != nullptr) return out.ask(DismissNotice{});
    if (frame.drawing()) return out.ask(ToggleDrawing{});
    if (frame.viewer.ground_pen) return out.ask(ToggleGroundPen{});
    if (frame.preserve != nullptr) {
        if (frame.preserve->single) return out.ask(ShowWorld{});
        if (frame.preserve->wall.on) return out.ask(ToggleWalls{});
        out.ask(PickResident{0});
    } else if (frame.picking != nullptr && frame.picking->single) {
        out.ask(ShowGrid{});
    }
}

}  // namespace

bool close_card(const FrameContext& frame, Requests& out) {
    if (frame.window.palette_open) {
        out.ask(TogglePalette{});
    } else if (frame.tour_shown()) {
        out.ask(TurnTour{-1});
    } else if (frame.start_shown()) {
        out.ask(ToggleStartPage{});
    } else if (frame.samples_shown()) {
        out.ask(ToggleSamples{});
    } else if (frame.preserve_card.open) {
        out.ask(TogglePreserveCard{});
    } else if (frame.files.browser.open) {
        out.ask(CloseFilePanel{});
    } else if (frame.machines != nullptr && frame.machines->card_open) {
        out.ask(ToggleMachines{});
    } else if (frame.comparison != nullptr && frame.comparison->card_open) {
        out.ask(ToggleComparison{});
    } else if (frame.guide.help_shown) {
        out.ask(ToggleHelp{});
    } else {
        return false;
    }
    return true;
}

std::vector<Action> view_actions() {
    using enum ThemeKind;
    constexpr auto panels = &ViewState::panels;
    constexpr auto left = &PanelSizes::left;
    constexpr auto right = &PanelSizes::right;
    // clang-format off
    std::vector<Action> actions = {
        {"panel-left", "", "Experiment", switch_side<left, right>, {}, is_side_shown<left, right>, "Show or hide the panel on the left."},
        {"panel-right", "", "Inspector", switch_side<right, left>, {}, is_side_shown<right, left>, "Show or hide the panel on the right."},
        {"panel-bottom", "", "Timeline and population", toggles<panels, &PanelSizes::bottom>, {}, is_on<panels, &PanelSizes::bottom>, "Show or hide the panels at the bottom."},
        {"rival", "", "A rival", toggles<&ViewState::rival>, {}, is_on<&ViewState::rival>, "A sample for the same goal in the same world runs along: the next one that the champions have to beat."},
        {"size-larger", "Ctrl+Plus", "Interface size: larger", change_size<1>, {}, {}, "Letters and controls of the window grow, up to 200 %."},
        {"size-smaller", "Ctrl+Minus", "Interface size: smaller", change_size<-1>, {}, {}, "Down to 80 %."},
        {"theme", "Ctrl+L", "Light theme", switch_theme, {}, is_light, "Or the dark one.", true},
        {"look", "L", "Switch the look", switch_look, {}, {}, "See creatures alive, through their skin, or as boxes.", true},
        {"full-screen", "F11", "Full screen", asks<ToggleFullScreen{}>, {}, is_full_screen, "", true},
        {"present", "Shift+F11", "Presentation", asks<TogglePresentation{}>, may_present, {}, "The best creatures, one after the other, on the whole screen. Any key ends it."},
        {"close", "Esc", "Close the open menu or card", close_what_is_open, {}, {}, "", true},
    };
    // clang-format on
    add_sizes(actions);
    add_choices<&ViewState::look>(actions, kLookLines);
    add_choices<&ViewState::scenery>(actions, kSceneryLines);
    add_choices<&ViewState::ghosts>(actions, kGhostLines);
    add_overlays(actions);
    return actions;
}

std::vector<Action> help_actions() {
    const auto shows = [](const char* page) {
        return [page](const FrameContext&, Requests& out) { out.ask(ShowHelp{page}); };
    };
    return {
        {"help", "F1", "Help", asks<ToggleHelp{}>},
        {"palette",
         "Ctrl+P",
         "Find anything…",
         asks<TogglePalette{}>,
         {},
         {},
         "Type what to do, a setting or words of the help."},
        {"keys", "", "Keys", shows(kKeysPage)},
        {"tour", "", "Tour of the window", asks<TurnTour{0}>},
        {"about", "", "About Cambrian", shows(kAboutPage)},
    };
}

}  // namespace cambrian
