#pragma once

// Owns the open experiment: evolution, its settings, and where it is kept.

#include "studio/background/services.h"
#include "studio/experiment/experiment_contract.h"
#include "studio/experiment/open_experiment.h"
#include "studio/look/view_state.h"
#include "studio/viewer/viewer_controller.h"

namespace cambrian {

class ExperimentController {
public:
    // Everything that `services` names, `view` and `viewer` must outlive it.
    ExperimentController(const Services& services, ViewState& view, ViewerController& viewer,
                         ExperimentSettings settings, std::shared_ptr<EvaluationBackend> backend);

    // Once a frame, in this order: reads what the engine did, and says whether it runs or failed.
    void poll() { experiment_.poll(); }
    void follow_status();
    void carry_out(const ExperimentRequest& request);
    ExperimentView facts() const;

    // New runs are kept in this file from now on, the run before beside it.
    void keep_in(const std::filesystem::path& file);
    const std::filesystem::path& own_file() const { return own_file_; }
    // While a person picks by hand, evolution pauses and cannot be started.
    void suspend();
    // Ends that; `resume` goes on with evolution if it was running before.
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
    std::filesystem::path own_file_;
    EngineStatus seen_status_ = EngineStatus::kPaused;
    bool suspended_ = false;
    bool evolved_before_ = false;  // when evolution was suspended
    bool previous_run_ = false;
    unsigned find_asked_ = 0;
};

}  // namespace cambrian
