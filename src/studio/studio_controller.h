#pragma once

// The studio without its window. Each subject has a controller, which owns its data and carries out
// its requests; the studio controller routes requests to them and lets them act in order, once a
// frame.

#include "studio/coach/coach_controller.h"
#include "studio/comparison/comparison_controller.h"
#include "studio/files/files_controller.h"
#include "studio/frame/frame_context.h"
#include "studio/help/guide_controller.h"
#include "studio/machines/machines_controller.h"
#include "studio/memory.h"
#include "studio/presentation.h"
#include "studio/preserve/preserve_controller.h"
#include "studio/window_controller.h"

#include <filesystem>

namespace cambrian {

class StudioController {
public:
    // `kinds` are those of the remembered settings, and `elsewhere` those of the world with other
    // dimensions, or null. Both must outlive it.
    StudioController(const Preferences& remembered, const EvolutionKinds& kinds,
                     const MachineOptions& machines, const std::filesystem::path& status_log,
                     const EvolutionKinds* elsewhere = nullptr);

    // Stores arrangement, settings and experiment in a folder from now on, whenever they change.
    void remember_in(const std::filesystem::path& folder);
    // Reopens, in the background, the experiment that was open when the folder was last used.
    void reopen_last();
    void keep_memory();
    // Keeps the state and the run's champion, because the window closes.
    void close();
    // Returns what is stored of the present state.
    Preferences remembered() const;
    // Sets the folder of the help pages and samples.
    void use_assets(const std::filesystem::path& folder);
    // Displays the founders of the run, so that the viewport is never empty.
    void show_founders() { experiment_.show_founder(0); }

    // Must be called once a frame, before drawing. Handles results of the engine and of files, then
    // plays on by `elapsed` seconds. `now` is in seconds of the window's clock.
    void update(double now, double elapsed);
    void carry_out(Requests& requests);
    FrameContext frame_context() const;

    const ViewState& view() const { return view_; }
    bool presenting() const { return presentation_.on(); }
    bool animating() const;  // whether the next frame differs without input
    // Time spent on playback in the last update, in s.
    double playback_seconds() const { return playback_seconds_; }
    WindowController& window() { return window_; }
    GuideController& guide() { return guide_; }
    FilesController& files() { return files_; }
    MachinesController& machines() { return machines_; }
    Feedback& feedback() { return services_.feedback; }

private:
    struct Router;
    void present(double now);
    void switch_presentation();
    std::vector<Exhibit> sample_exhibits() const;

    ViewState view_;
    OwnServices services_;
    WindowController window_;
    GuideController guide_;
    ViewerController viewer_;
    MachinesController machines_;
    ExperimentController experiment_;
    GenerationsController generations_;
    PickingController picking_;
    PreserveController preserve_;
    ComparisonController comparison_;
    CoachController coach_;
    FilesController files_;
    Memory memory_;
    Presentation presentation_;
    bool newest_before_ = false;  // ViewState::newest_champion before the presentation
    double playback_seconds_ = 0.0;
};

}  // namespace cambrian
