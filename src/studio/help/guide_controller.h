#pragma once

// Owns the help pages and the tour.

#include "studio/background/services.h"
#include "studio/help/guide_contract.h"
#include "studio/help/tour.h"
#include "studio/look/view_state.h"

#include <filesystem>
#include <string>

namespace cambrian {

class GuideController {
public:
    // The references in `services`, and `view`, must outlive the controller.
    GuideController(const Services& services, ViewState& view)
        : services_(services), view_(view), facts_{.help = &help_} {}

    // Reads the pages of a folder in the background. `keys` and `words` are the texts of the pages
    // on keys and on the words for settings.
    void read(const std::filesystem::path& folder, std::string keys, std::string words);
    // Starts the tour unless the user took or declined it before.
    void offer_tour();
    // Must be called once a frame with what the user did so far; a deed that the tour waits for
    // leads to its next step.
    void follow(const Deeds& deeds);
    void carry_out(const GuideRequest& request);
    GuideView facts() const { return facts_; }

private:
    struct Handler;
    void show_pictures();

    Services services_;
    ViewState& view_;
    std::filesystem::path folder_;
    HelpIndex help_;
    GuideView facts_;
    Deeds deeds_;   // of the last frame
    Deeds before_;  // when the tour's step was displayed
};

}  // namespace cambrian
