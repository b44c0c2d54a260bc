#include "studio/actions/subjects.h"

namespace cambrian {
namespace {

bool has_generations(const FrameContext& frame) {
    return !frame.experiment.snapshot.history.empty();
}
bool has_run_before(const FrameContext& frame) {
    return frame.experiment.previous_run;
}
bool has_preserve(const FrameContext& frame) {
    return frame.preserve != nullptr;
}
bool has_creature(const FrameContext& frame) {
    return !frame.viewer.playback.empty();
}
bool has_runners(const FrameContext& frame) {
    return frame.generations.stars.all().size() >= 2;
}
void take_screenshot(const FrameContext&, Requests& out) {
    out.ask(SaveScreenshot{});
}

}  // namespace

std::vector<Action> file_actions() {
    using enum FileTask;
    // clang-format off
    return {
        {"open", "Ctrl+O", "Open…", asks<OpenFilePanel{kOpen}>, {}, {}, "A creature, an experiment, a preserve or settings."},
        {"start", "", "Start page…", asks<ToggleStartPage{}>, {}, {}, "The runs that were used lately, and the samples."},
        {"samples", "Ctrl+Shift+O", "Samples…", asks<ToggleSamples{}>, {}, {}, "Creatures that were evolved before."},
        {"previous-run", "", "Open the run before", asks<OpenPreviousRun{}>, has_run_before},
        {"new-preserve", "Ctrl+N", "New preserve…", asks<TogglePreserveCard{}>, {}, {}, "A closed world in which creatures feed, breed and die."},
        {"close-preserve", "Ctrl+W", "Close preserve", asks<ClosePreserve{}>, has_preserve},
        {"save-experiment", "Ctrl+K", "Save experiment…", asks<OpenFilePanel{kSaveExperiment}>},
        {"save-clip", "Ctrl+Shift+R", "Save clip…", asks<OpenFilePanel{kSaveClip}>, has_creature, {}, "The creature on display in motion: a GIF, an MP4, or a card that moves.", true},
        {"save-run-page", "", "Save page of this run…", asks<OpenFilePanel{kSaveRunPage}>, has_generations, {}, "Its champions and their course, for any browser."},
        {"save-film", "", "Save film of this run…", asks<OpenFilePanel{kSaveFilm}>, has_generations, {}, "Its champions one after the other: a GIF or an MP4."},
        {"save-race", "", "Save race of the starred…", asks<OpenFilePanel{kSaveRace}>, has_runners, {}, "Two to six creatures in lanes, in the world of the one on display."},
        {"save-settings", "Ctrl+Shift+S", "Save settings…", asks<OpenFilePanel{kSaveSettings}>},
        {"export-statistics", "Ctrl+E", "Export statistics as CSV…", asks<OpenFilePanel{kSaveStatistics}>, has_generations},
        {"export-plot", "Ctrl+Shift+E", "Export plot as PNG, 1280 × 720…", asks<OpenFilePanel{kSavePlot}>, has_generations},
        {"export-plot-large", "", "Export plot as PNG, 1920 × 1080…", asks<OpenFilePanel{kSavePlot, {1920, 1080}}>, has_generations},
        {"screenshot", "F12", "Save picture of the window", take_screenshot, {}, {}, "", true},
        {"save-seen", "Shift+F12", "Save the last ten seconds as seen", asks<SaveSeen{}>, {}, {}, "A GIF of the viewport with its overlays and ghosts, beside the pictures of the window.", true},
        {"copy-picture", "Ctrl+Shift+C", "Copy picture of the viewport", asks<CopyPicture{}>, {}, {}, "", true},
        {"quit", "Ctrl+Q", "Quit", asks<QuitStudio{}>, {}, {}, "", true},
    };
    // clang-format on
}

}  // namespace cambrian
