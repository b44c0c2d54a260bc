#pragma once

// Displays creatures of the experiment's generations, and owns the list of starred creatures.

#include "studio/experiment/experiment_controller.h"
#include "studio/experiment/generations_contract.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace cambrian {

class GenerationsController {
public:
    // The references in `services`, and `view`, `viewer` and `experiment`, must outlive the
    // controller.
    GenerationsController(const Services& services, ViewState& view, ViewerController& viewer,
                          ExperimentController& experiment)
        : services_(services), view_(view), viewer_(viewer), experiment_(experiment) {}

    void carry_out(const GenerationsRequest& request);
    GenerationsView facts() const { return {.stars = stars_}; }

    // Must be called once a frame; writes finished generations to the status log.
    void log_finished();
    // Displays the newest champion if the user chose to follow it.
    void follow_newest();
    // Must be called once a frame: a displayed champion that was audited gets the scores of the
    // audit.
    void follow_audit();
    // Must be called once a frame; saves the stars in the experiment's file if they changed. A new
    // run has none.
    void keep_stars();
    // Replaces the stars by those of an experiment that was opened.
    void replace_stars(std::vector<JudgedIndividual> stars);

private:
    struct Handler;
    void show_champion(const JudgedIndividual& champion);
    const JudgedIndividual* champion_of(std::uint32_t generation) const;
    std::optional<JudgedIndividual> creature_on_display() const;

    Services services_;
    ViewState& view_;
    ViewerController& viewer_;
    ExperimentController& experiment_;
    Stars stars_;
    std::uint64_t kept_stars_ = 0;  // revision of the stars that were saved last
    unsigned starred_run_ = 0;      // number of runs begun when the stars were given
    std::uint64_t seen_experiment_ = 0;
    std::size_t seen_rows_ = 0;
};

}  // namespace cambrian
