#pragma once

// Owns the open experiment: its evolution, its settings and its file.

#include "studio/background/services.h"
#include "studio/experiment/experiment_contract.h"
#include "studio/experiment/open_experiment.h"
#include "studio/look/view_state.h"
#include "studio/viewer/viewer_controller.h"

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
    void keep_in(const std::filesystem::path& file) { experiment_.autosave_in(file); }
    // Pauses evolution and forbids starting it while the user selects by hand.
    void suspend();
    // Ends the suspension; with `resume`, evolution continues if it was running before.
    void release(bool resume);
    void show_random_creature();

    OpenExperiment& open() { return experiment_; }
    const OpenExperiment& open() const { return experiment_; }

private:
    struct Handler;
    void commit();
    void change_draft(void (SettingsEditor::*change)());
    void follow_world(const Environment& before);

    Services services_;
    ViewState& view_;
    ViewerController& viewer_;
    OpenExperiment experiment_;
    EngineStatus seen_status_ = EngineStatus::kPaused;
    std::uint32_t seen_generation_ = 0;
    bool suspended_ = false;
    bool evolved_before_ = false;  // whether evolution ran when it was suspended
    bool resuming_ = false;        // was told to go on, which the snapshot does not show yet
    unsigned find_asked_ = 0;
};

}  // namespace cambrian
