#include "studio/help/guide_controller.h"

#include <algorithm>
#include <utility>

namespace cambrian {

// Has one overload for each kind of request.
struct GuideController::Handler {
    GuideController& self;

    void operator()(const ToggleHelp&) const {
        self.facts_.help_shown = !self.facts_.help_shown;
        if (!self.facts_.help_shown) return;
        self.services_.feedback.log().write("help", {{"page", self.help_.open}});
        self.show_pictures();
    }
    void operator()(const ShowHelp& request) const {
        self.help_.open = request.page;
        self.facts_.help_shown = true;
        self.facts_.help_block = request.block;
        ++self.facts_.help_asked;
        self.services_.feedback.log().write("help", {{"page", request.page}});
        self.show_pictures();
    }
    void operator()(const TurnTour& request) const {
        const bool over = request.step < 0 || request.step >= static_cast<int>(tour_steps().size());
        self.facts_.tour_step = over ? -1 : request.step;
        self.before_ = self.deeds_;
        self.services_.feedback.log().write("tour",
                                            {{"step", static_cast<double>(self.facts_.tour_step)}});
        if (over) self.view_.tour_taken = true;
    }
};

void GuideController::read(const std::filesystem::path& folder, std::string keys,
                           std::string words) {
    folder_ = folder;
    services_.worker.submit(
        [this, folder, keys = std::move(keys), words = std::move(words)](const std::stop_token&) {
            auto pages = read_help(folder, keys, words);
            return [this, pages = std::move(pages)] {
                help_.pages = pages;
                if (facts_.help_shown) show_pictures();
            };
        });
}

// Reads the pictures of the open page in the background, unless it has them already.
void GuideController::show_pictures() {
    const HelpPage* page = help_.open_page();
    if (page == nullptr) return;
    const bool is_complete =
        std::none_of(page->blocks.begin(), page->blocks.end(), [](const MarkdownBlock& block) {
            return block.kind == BlockKind::kPicture && !block.picture;
        });
    if (is_complete) return;
    services_.worker.submit([this, folder = folder_, page = *page](const std::stop_token&) {
        auto pictures = read_pictures(folder, page);
        return [this, pictures = std::move(pictures)] { add_pictures(help_, pictures); };
    });
}

void GuideController::offer_tour() {
    if (!view_.tour_taken) carry_out(TurnTour{0});
}

void GuideController::follow(const Deeds& deeds) {
    deeds_ = deeds;
    if (facts_.tour_step < 0) return;
    const TourStep& step = tour_steps()[static_cast<std::size_t>(facts_.tour_step)];
    if (step.done(before_, deeds_)) carry_out(TurnTour{facts_.tour_step + 1});
}

void GuideController::carry_out(const GuideRequest& request) {
    std::visit(Handler{*this}, request);
}

}  // namespace cambrian
