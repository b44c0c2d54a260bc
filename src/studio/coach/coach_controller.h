#pragma once

// Accompanies a run: shows its founders before it begins, lets a sample creature run along as a
// rival of its champions, and suggests what to change when it is stuck.

#include "studio/coach/coach_contract.h"
#include "studio/coach/rivals.h"
#include "studio/experiment/experiment_controller.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace cambrian {

class CoachController {
public:
    // The references in `services`, and `view`, `viewer` and `experiment`, must outlive the
    // controller.
    CoachController(const Services& services, ViewState& view, ViewerController& viewer,
                    ExperimentController& experiment);

    // Sets the folder of the sample creatures, from which rivals are taken.
    void use_samples(const std::filesystem::path& folder) { samples_folder_ = folder; }
    // Must be called once a frame.
    void update(double elapsed);
    void carry_out(const CoachRequest& request);
    CoachView facts() const;
    // Whether the founders of the run are displayed: nothing of it is judged yet, and its first
    // creature is the one on display.
    bool founders_shown() const;

private:
    struct Handler;
    void follow_founders(double elapsed);
    void follow_rivals();
    void judge_rivals_of(const SettingsPtr& settings);
    void race(const EvolutionSnapshot& snapshot);
    void celebrate(const JudgedIndividual& champion, const JudgedRival& beaten);
    void run_along();
    void follow_plateau();

    Services services_;
    ViewState& view_;
    ViewerController& viewer_;
    ExperimentController& experiment_;
    std::filesystem::path samples_folder_;
    FounderCrowd crowd_;
    std::uint64_t crowd_of_ = 0;  // the experiment whose founders the crowd has

    SettingsPtr rivals_settings_;  // under which the rivals are judged; null before
    bool rivals_judged_ = false;
    std::vector<JudgedRival> rivals_;
    std::size_t ahead_ = 0;       // number of rivals that were beaten in this run
    std::uint64_t raced_ = 0;     // the experiment that `ahead_` is of
    std::size_t races_from_ = 0;  // number of champions when that experiment was opened
    std::size_t races_ = 0;       // number of champions compared so far
    std::uint64_t advised_ = 0;   // the experiment for which suggestions were displayed last
    bool suggestions_ = false;
    BackgroundWorker worker_;  // last member, so that its jobs end first
};

}  // namespace cambrian
