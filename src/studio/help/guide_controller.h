#pragma once

// Owns the help pages and the tour.

#include "studio/background/services.h"
#include "studio/help/guide_contract.h"
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
};

}  // namespace cambrian
