#pragma once

// Puts creatures of the experiment's generations on display, and owns which of them have a star.

#include "studio/experiment/experiment_controller.h"
#include "studio/experiment/generations_contract.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace cambrian {

class GenerationsController {
public:
    // Everything that `services` names, `view`, `viewer` and `experiment` must outlive it.
    GenerationsController(const Services& services, ViewState& view, ViewerController& viewer,
                          ExperimentController& experiment)
        : services_(services), view_(view), viewer_(viewer), experiment_(experiment) {}

    void carry_out(const GenerationsRequest& request);
    GenerationsView facts() const { return {.stars = stars_}; }

    // Once a frame: writes finished generations to the log.
    void log_finished();
    // Displays the newest champion if the person follows the champions.
    void follow_newest();
    // Once a frame: writes the stars to the experiment's file if they changed.
    void keep_stars();
    // The stars of an experiment that was opened.
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
    std::uint64_t kept_stars_ = 0;  // revision
    std::uint64_t seen_experiment_ = 0;
    std::size_t seen_champions_ = 0;
};

}  // namespace cambrian
