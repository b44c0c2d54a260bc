#pragma once

// What panels see, put together without an engine: settings, an empty history, a creature.

#include "evolution/snapshot.h"
#include "studio/frame_context.h"
#include "studio/requests.h"
#include "support/creatures.h"
#include "support/kinds.h"

#include <memory>
#include <variant>

namespace cambrian::test {

class StudioFixture {
public:
    StudioFixture() {
        snapshot_.settings = std::make_shared<const ExperimentSettings>(editor_.draft());
        snapshot_.journal.push_back({0, snapshot_.settings});
    }

    // The crawler takes the stage.
    void show_crawler() {
        Exhibit exhibit;
        exhibit.genome = crawler(kinds().creature.catalog);
        exhibit.goal = "walking";
        exhibit.title = "Crawler";
        REQUIRE(playback_.show(std::move(exhibit)));
    }
    // One more finished generation whose best scored so much.
    void finish_generation(double best) {
        auto champion = std::make_shared<Individual>();
        champion->genome = crawler(kinds().creature.catalog);
        champion->evaluated = true;
        champion->result.fitness = best;
        GenerationStatistics row;
        row.generation = snapshot_.generation++;
        row.best = best;
        row.upper = 0.9 * best;
        row.median = 0.5 * best;
        snapshot_.history.push_back(row);
        snapshot_.champions.push_back({row.generation, champion, snapshot_.settings});
        snapshot_.population = {champion};
    }
    FrameContext frame() const {
        return {.kinds = kinds(),
                .fields = fields_,
                .snapshot = snapshot_,
                .progress = progress_,
                .editor = editor_,
                .playback = playback_,
                .view = view_,
                .files = files_,
                .stars = stars_};
    }

    EvolutionSnapshot& snapshot() { return snapshot_; }
    SettingsEditor& editor() { return editor_; }
    Playback& playback() { return playback_; }
    FileBrowser& files() { return files_; }
    Stars& stars() { return stars_; }
    ViewState& view() { return view_; }

private:
    std::vector<SettingField> fields_ = setting_fields(kinds());
    SettingsEditor editor_{ExperimentSettings{}};
    EvolutionSnapshot snapshot_;
    ProgressView progress_;
    Playback playback_{kinds().creature};
    ViewState view_;
    FileBrowser files_;
    Stars stars_;
};

// The only action of a kind that was asked for; fails the test if there is none.
template <class Action>
const Action& asked(const Requests& requests) {
    const Action* found = nullptr;
    for (const StudioAction& action : requests.actions()) {
        if (const auto* match = std::get_if<Action>(&action)) found = match;
    }
    REQUIRE(found != nullptr);
    return *found;
}

template <class Action>
bool was_asked(const Requests& requests) {
    for (const StudioAction& action : requests.actions()) {
        if (std::holds_alternative<Action>(action)) return true;
    }
    return false;
}

}  // namespace cambrian::test
