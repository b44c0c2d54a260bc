// What a session does to help a person find the way: help pages, the tour, samples.

#include "studio/help/tour.h"
#include "studio/session.h"
#include "studio/shortcuts.h"

#include <utility>

namespace cambrian {

void Session::use_assets(const std::filesystem::path& folder) {
    worker_.submit([this, folder](const std::stop_token&) {
        auto pages = read_help(folder / "help", keys_text());
        return [this, pages = std::move(pages)] { help_.pages = pages; };
    });
    samples_folder_ = folder / "creatures";
}

void Session::offer_tour() {
    if (!view_.tour_taken) apply(TurnTour{0});
}

void Session::apply(const TurnTour& action) {
    const bool over = action.step < 0 || action.step >= static_cast<int>(tour_steps().size());
    tour_step_ = over ? -1 : action.step;
    log_.write("tour", {{"step", static_cast<double>(tour_step_)}});
    if (over) view_.tour_taken = true;
}

void Session::apply(const ShowHelp& action) {
    help_.open = action.page;
    help_shown_ = true;
    log_.write("help", {{"page", action.page}});
}

void Session::apply(const ToggleHelp&) {
    help_shown_ = !help_shown_;
    if (help_shown_) log_.write("help", {{"page", help_.open}});
}

void Session::apply(const FindSetting&) {
    view_.left_panel = true;
    ++find_asked_;
}

// The folder is gone through each time, so that creatures put there meanwhile are found.
void Session::apply(const ToggleSamples&) {
    samples_.open = !samples_.open;
    if (!samples_.open) return;
    worker_.submit([this, folder = samples_folder_, &kinds = kinds_](const std::stop_token&) {
        auto found = read_samples(folder, kinds);
        return [this, found = std::move(found)] {
            samples_.samples = found;
            samples_.read = true;
            log_.write("samples", {{"count", static_cast<double>(found.size())}});
        };
    });
}

}  // namespace cambrian
