#pragma once

// Owns the open experiment: its evolution, its settings and its file.

#include "studio/background/services.h"
#include "studio/experiment/experiment_contract.h"
#include "studio/experiment/museum_keeper.h"
#include "studio/experiment/open_experiment.h"
#include "studio/look/view_state.h"
#include "studio/viewer/viewer_controller.h"

#include <cstddef>

namespace cambrian {

class ExperimentController {
public:
    // The references in `services`, and `view` and `viewer`, must outlive the controller.
    ExperimentController(const Services& services, ViewState& view, ViewerController& viewer,
                         ExperimentSettings settings, std::shared_ptr<EvaluationBackend> backend);

    // Must be called once a frame, in this order: poll() reads the engine's latest snapshot,
    // follow_status() reports whether evolution runs or failed.
    void poll();
    void follow_status();
    void carry_out(const ExperimentRequest& request);
    ExperimentView facts() const;

    // Saves new runs in this file from now on; the run before is kept in a file beside it.
    // Champions go into the museum and founders come from it.
    void keep_in(const std::filesystem::path& file, const std::filesystem::path& museum);
    // Must be called when the window closes.
    void close() { museum_.close(); }
    // Pauses evolution and forbids starting it while the user selects by hand.
    void suspend();
    // Ends the suspension; with `resume`, evolution continues if it was running before.
    void release(bool resume);
    // Displays a creature of generation 0 of a run of random creatures with the draft settings.
    void show_founder(std::size_t place);
    // Whether a new run was the last thing done, so that undoing means to open the run before.
    bool new_run_last() const { return new_run_last_ && !experiment_.files().before().empty(); }
    // Must be called when the user does something else that can be undone.
    void forget_new_run() { new_run_last_ = false; }

    OpenExperiment& open() { return experiment_; }
    const OpenExperiment& open() const { return experiment_; }

private:
    struct Handler;
    void begin_run(std::vector<GenomePtr> founders, RunSeed seed);
    void leave_museum();
    void take_over_world(const Exhibit& exhibit);
    void commit();
    void change_draft(void (SettingsEditor::*change)());
    void follow_world(const Environment& before);

    Services services_;
    ViewState& view_;
    ViewerController& viewer_;
    OpenExperiment experiment_;
    MuseumKeeper museum_;
    EngineStatus seen_status_ = EngineStatus::kPaused;
    std::uint32_t seen_generation_ = 0;
    bool suspended_ = false;
    bool evolved_before_ = false;  // whether evolution ran when it was suspended
    bool resuming_ = false;        // was told to go on, which the snapshot does not show yet
    bool new_run_last_ = false;
    unsigned find_asked_ = 0;
    unsigned show_asked_ = 0;
    std::string shown_;
};

}  // namespace cambrian
