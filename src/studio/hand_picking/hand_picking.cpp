#include "studio/hand_picking/hand_picking.h"

#include "evolution/backends/thread_pool_backend.h"
#include "evolution/evaluation/trials.h"

#include <fmt/core.h>

#include <algorithm>

namespace cambrian {

void HandPicking::enter(const EvolutionSnapshot& evolution, const GenomePtr& on_show) {
    bool first = engine_ == nullptr;
    if (first) {
        engine_ = std::make_unique<PickingEngine>(
            evolution.settings, kinds_,
            make_thread_pool_backend(kinds_, threads_.workers, threads_.priority));
        snapshot_ = engine_->latest();
        used_ = evolution.settings;
    }
    on_ = true;
    choices_.single = false;
    use(evolution.settings);
    if (restored_) {
        PickingRecord record = *std::exchange(restored_, std::nullopt);
        const bool empty = record.tree.empty();
        send(
            RestoreGrids{std::move(record.tree), std::move(record.picks), std::move(record.shelf)});
        if (!empty) return;
        first = true;
    }
    const std::pair population = {evolution.experiment, evolution.history.size()};
    if (!evolution.population.empty() && (first || population != left_)) {
        send(ShowPopulation{evolution.settings, evolution.population});
    } else if (first) {
        StartFromCreatures start;
        if (on_show) start.genomes.push_back(on_show);
        send(std::move(start));
    }
}

void HandPicking::leave(const EvolutionSnapshot& evolution) {
    on_ = false;
    choices_.single = false;
    left_ = {evolution.experiment, evolution.history.size()};
}

void HandPicking::restore(PickingRecord record) {
    if (engine_ == nullptr && record.tree.empty() && record.shelf.empty()) return;
    restored_ = std::move(record);
    if (!on_) return;
    PickingRecord present = *std::exchange(restored_, std::nullopt);
    send(RestoreGrids{std::move(present.tree), std::move(present.picks), std::move(present.shelf)});
}

void HandPicking::use(const SettingsPtr& settings) {
    if (!on_ || settings == used_) return;
    used_ = settings;
    send(UseSettings{settings});
}

void HandPicking::update(double elapsed, StatusLog& log) {
    if (!on_) return;
    snapshot_ = engine_->latest();
    if (snapshot_ != seen_) {
        follow_grid(log);
        follow_picks(log);
        seen_ = snapshot_;
    }
    motion_.advance(choices_.playing && !choices_.single ? elapsed : 0.0);
}

// The displayed grid moves in the world that evaluated it, but with the present environment.
void HandPicking::follow_grid(StatusLog& log) {
    if (snapshot_->tree.empty()) return;
    const GridNode& grid = snapshot_->tree.current();
    const bool another = !seen_ || seen_->tree.empty() ||
                         seen_->tree.current().number != grid.number ||
                         seen_->tree.current().creatures != grid.creatures;
    const Environment& environment = snapshot_->settings->world.environment;
    if (!another && motion_.environment() == environment) return;
    TrialWorld world = first_trial_world(*grid.settings);
    world.environment = environment;
    motion_.show(grid.creatures, grid.settings->expression, world);
    if (!another) return;
    choices_.focus = 0;
    choices_.single = false;
    log.write("grid", {{"number", static_cast<double>(grid.number)},
                       {"parent", grid.parent ? static_cast<double>(*grid.parent) : -1.0},
                       {"cells", static_cast<double>(grid.creatures.size())},
                       {"origin", origin_words(grid)},
                       {"grids", static_cast<double>(snapshot_->tree.size())}});
}

void HandPicking::follow_picks(StatusLog& log) {
    if (seen_ && seen_->picks == snapshot_->picks) return;
    log.write("picks", {{"count", static_cast<double>(snapshot_->picks.size())}});
}

std::vector<IndividualPtr> HandPicking::picks() const {
    return snapshot_->tree.empty() ? std::vector<IndividualPtr>() : picked_creatures(*snapshot_);
}

bool HandPicking::has_cell(std::size_t cell) const {
    return on_ && !snapshot_->tree.empty() && cell < snapshot_->tree.current().creatures.size();
}

Exhibit HandPicking::exhibit(std::size_t cell) const {
    const GridNode& grid = snapshot_->tree.current();
    Exhibit exhibit = exhibit_of(grid.cell(cell), ExhibitSource::kHandPicked);
    exhibit.title = fmt::format("Creature {} of grid {}", cell + 1, grid.number + 1);
    return exhibit;
}

PickingView HandPicking::view() const {
    const auto share = [](double done, double total) {
        return total > 0.0 ? static_cast<float>(std::min(1.0, done / total)) : 0.0F;
    };
    const EvaluationProgress& batch = engine_->progress();
    const double in_batch = static_cast<double>(share(batch.done, batch.total));
    const bool evolving = snapshot_->status == PickingStatus::kEvolving;
    return {.snapshot = *snapshot_,
            .motion = motion_,
            .options = choices_.options,
            .focus = choices_.focus,
            .single = choices_.single,
            .playing = choices_.playing,
            .progress = evolving ? share(snapshot_->generations_done + in_batch,
                                         snapshot_->generations_asked + 1)
                                 : static_cast<float>(in_batch)};
}

}  // namespace cambrian
