#pragma once

// What panels see, made without an engine: settings, an empty history, a creature.

#include "evolution/engine/snapshot.h"
#include "evolution/generation.h"
#include "studio/frame/frame_context.h"
#include "studio/frame/requests.h"
#include "support/creatures.h"
#include "support/kinds.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

namespace cambrian::test {

// Returns a creature as an exhibit that walks in the world of the settings.
inline Exhibit walking_exhibit(GenomePtr genome, ExperimentSettings settings = {}) {
    settings.goal = "walking";
    return {.creature = unjudged(std::move(genome),
                                 std::make_shared<const ExperimentSettings>(settings), ""),
            .title = "Crawler"};
}

inline Exhibit crawler_exhibit(const ExperimentSettings& settings = {}) {
    return walking_exhibit(crawler(kinds().creature.catalog), settings);
}

class StudioFixture {
public:
    StudioFixture() {
        snapshot_.settings = std::make_shared<const ExperimentSettings>(editor_.draft());
        snapshot_.journal.push_back({0, snapshot_.settings});
    }

    // Displays the crawler.
    void show_crawler() { REQUIRE(playback_.show(crawler_exhibit())); }
    // Displays the crawler with a voice and a scent gland that always work.
    void show_calling_crawler() {
        Genome genome = *crawler(kinds().creature.catalog);
        for (const char* organ : {"sound", "scent"}) {
            const std::uint8_t kind =
                CreatureBuilder::index_of(kinds().creature.catalog.organs, organ);
            genome.nodes[0].organs.push_back({.kind = kind, .input = {{}, 1.0}});
        }
        REQUIRE(playback_.show(walking_exhibit(std::make_shared<const Genome>(genome))));
    }
    // Adds a finished generation with this best score.
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
    // Turns selection by hand on and adds a grid of so many creatures.
    void show_grid(std::size_t cells, GridOrigin origin = GridOrigin::kPopulation) {
        GridNode grid;
        grid.origin = origin;
        grid.settings = snapshot_.settings;
        for (std::size_t i = 0; i < cells; ++i)
            grid.creatures.push_back(make_immigrant(*snapshot_.settings, kinds(), 0, i));
        picking_.tree.add(std::move(grid));
        picking_.settings = snapshot_.settings;
        motion_.show(picking_.tree.current().creatures, snapshot_.settings->expression,
                     snapshot_.settings->world);
        view_picking();
    }
    void view_picking() {
        picking_view_.emplace(PickingView{.snapshot = picking_,
                                          .motion = motion_,
                                          .options = options_,
                                          .focus = focus_,
                                          .single = single_});
    }
    void focus_cell(std::size_t cell) {
        focus_ = cell;
        view_picking();
    }
    void show_single() {
        single_ = true;
        view_picking();
    }
    FrameContext frame() const {
        return {.kinds = kinds(),
                .view = view_,
                .experiment = {.fields = fields_,
                               .snapshot = snapshot_,
                               .progress = progress_,
                               .editor = editor_},
                .generations = {.stars = stars_},
                .viewer = {.playback = playback_},
                .files = {.browser = files_},
                .picking = picking_view_ ? &*picking_view_ : nullptr,
                .machines = &machines_,
                .comparison = &comparison_,
                .preserve_card = preserve_card_};
    }

    PickingSnapshot& picking() { return picking_; }
    EvolutionSnapshot& snapshot() { return snapshot_; }
    SettingsEditor& editor() { return editor_; }
    Playback& playback() { return playback_; }
    FileBrowser& files() { return files_; }
    MachinesView& machines() { return machines_; }
    ComparisonView& comparison() { return comparison_; }
    Stars& stars() { return stars_; }
    PreserveCardView& preserve_card() { return preserve_card_; }
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
    PickingSnapshot picking_;
    GridMotion motion_{kinds().creature};
    PickingOptions options_;
    std::size_t focus_ = 0;
    bool single_ = false;
    std::optional<PickingView> picking_view_;
    MachinesView machines_;
    ComparisonView comparison_;
    PreserveCardView preserve_card_;
};

// Returns the request if it is of this kind, otherwise null.
template <class Kind>
const Kind* request_if(const StudioRequest& request) {
    const auto* subject = std::get_if<SubjectOf<Kind>>(&request);
    return subject == nullptr ? nullptr : std::get_if<Kind>(subject);
}

// Makes the same requests.
inline void ask_again(const Requests& requests, Requests& out) {
    const auto ask = [&out](const auto& request) { out.ask(request); };
    for (const StudioRequest& request : requests.all())
        std::visit([&ask](const auto& subject) { std::visit(ask, subject); }, request);
}

// Returns the last request of a kind; the test fails if there is none.
template <class Kind>
const Kind& asked(const Requests& requests) {
    const Kind* found = nullptr;
    for (const StudioRequest& request : requests.all()) {
        if (const Kind* match = request_if<Kind>(request)) found = match;
    }
    REQUIRE(found != nullptr);
    return *found;
}

template <class Kind>
bool was_asked(const Requests& requests) {
    return std::any_of(
        requests.all().begin(), requests.all().end(),
        [](const StudioRequest& request) { return request_if<Kind>(request) != nullptr; });
}

// Returns the last command of a kind for the picking engine; the test fails if there is none.
template <class Command>
const Command& asked_picking(const Requests& requests) {
    const Command* found = nullptr;
    for (const StudioRequest& request : requests.all()) {
        const auto* asked = request_if<AskPicking>(request);
        if (asked == nullptr) continue;
        if (const auto* match = std::get_if<Command>(&asked->command)) found = match;
    }
    REQUIRE(found != nullptr);
    return *found;
}

}  // namespace cambrian::test
