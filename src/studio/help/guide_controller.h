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

    // Reads the pages of a folder in the background. `keys` is the text of the page on keys.
    void read(const std::filesystem::path& folder, std::string keys);
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
