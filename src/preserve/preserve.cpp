#include "preserve/preserve.h"

#include "core/assert.h"
#include "core/text/number_text.h"
#include "core/unused_memory.h"
#include "preserve/interventions.h"
#include "preserve/life/feeding.h"
#include "preserve/world/walls.h"

#include <fmt/core.h>

#include <cmath>
#include <utility>

namespace cambrian {
namespace {

// Returns whether the energies of a state add up to the constant of the world.
bool adds_up(const PreserveState& state, Energy constant) {
    Energy sum = 0;
    bool sound = true;
    const auto add = [&](Energy energy) {
        sound = sound && energy >= 0 && energy <= constant - sum;
        if (sound) sum += energy;
    };
    add(state.ambient);
    for (const auto* pellets : {&state.plants, &state.flesh}) {
        for (const Pellet& pellet : *pellets)
            add(pellet.energy);
    }
    for (const ResidentState& each : state.residents) {
        add(each.store);
        add(each.body);
    }
    return sound && sum == constant;
}

// Returns whether the energies, smells and walls of a state suit a world.
bool suits(const PreserveState& state, const PreserveWorld& world) {
    if (!adds_up(state, world.energy.constant)) return false;
    for (const auto* field : {&state.scents.scent, &state.scents.plants, &state.scents.flesh}) {
        if (field->any && field->cells.size() != world.senses.cells()) return false;
    }
    return state.walls.size() <= static_cast<std::size_t>(kMostFixedBoxes) &&
           std::all_of(state.walls.begin(), state.walls.end(), [&](const WallLine& wall) {
               return check_wall(wall, world.area).has_value();
           });
}

}  // namespace

Preserve::Preserve(SettingsPtr settings, const EvolutionKinds& kinds,
                   std::vector<GenomePtr> founders)
    : world_(std::move(settings), kinds),
      population_(world_, std::move(founders)),
      motion_(world_),
      broad_phase_(world_.area.torus()) {}

Result<std::unique_ptr<Preserve>> Preserve::begin(SettingsPtr settings, const EvolutionKinds& kinds,
                                                  std::vector<GenomePtr> founders) {
    std::unique_ptr<Preserve> preserve(
        new Preserve(std::move(settings), kinds, std::move(founders)));
    if (Status founded = preserve->found(); !founded) return founded.error();
    preserve->take_snapshot();
    return preserve;
}

Result<std::unique_ptr<Preserve>> Preserve::resume(SettingsPtr settings,
                                                   const EvolutionKinds& kinds,
                                                   std::vector<GenomePtr> founders,
                                                   const PreserveState& state, SettingsPtr laws) {
    std::unique_ptr<Preserve> preserve(
        new Preserve(std::move(settings), kinds, std::move(founders)));
    if (laws) preserve->world_.laws = std::move(laws);
    if (Status restored = preserve->restore(state); !restored) return restored.error();
    preserve->snapshot_tick_ = state.tick;
    return preserve;
}

Status Preserve::found() {
    const Energy plant = energy_of(settings()->preserve.plant_energy);
    if (plant > founding_energy()) {
        return Error{fmt::format(
            "[preserve] plant-energy: one plant has {} J, but the world has {} J; expected "
            "less, or a higher energy-density",
            short_text(joules(plant)), short_text(joules(founding_energy())))};
    }
    if (Status founded = population_.found(); !founded) return founded;
    world_.sow();
    return {};
}

Result<std::uint64_t> Preserve::intervene(Intervention asked) {
    if (!std::isfinite(asked.x) || !std::isfinite(asked.y) || !std::isfinite(asked.to_x) ||
        !std::isfinite(asked.to_y))
        return Error{"the place of an intervention is not finite"};
    asked.tick = ticks();
    if (asked.what == intervention::kRest) {
        rest();
    } else {
        Result<std::uint64_t> number = carry_out(asked, world_, population_);
        if (!number) return number;
        asked.number = *number;
    }
    world_.chronicle.interventions.push_back(asked);
    return asked.number;
}

Energy Preserve::total_energy() const {
    Energy total = world_.energy.total();
    for (const auto& each : residents())
        total += each->store + each->body;
    return total;
}

SeriesRow Preserve::row() const {
    return series_row(ticks(), residents(), ambient(), plants(), flesh(), world_.tally);
}

Chronicle Preserve::take_chronicle() {
    return std::exchange(world_.chronicle, {});
}

PreserveState Preserve::save() const {
    PreserveState state;
    state.tick = ticks();
    state.ambient = ambient();
    state.plants.assign(plants().all().begin(), plants().all().end());
    state.flesh.assign(flesh().all().begin(), flesh().all().end());
    state.scents = world_.senses.save();
    state.walls = walls().lines();
    population_.save(state);
    return state;
}

Status Preserve::restore(const PreserveState& state) {
    const Error unsuitable{"the snapshot does not belong to these settings"};
    if (!suits(state, world_)) return unsuitable;
    world_.tick = state.tick;
    world_.energy.light = state.ambient;
    world_.energy.plants.replace(state.plants);
    world_.energy.flesh.replace(state.flesh);
    world_.senses.restore(state.scents);
    world_.walls.replace(state.walls);
    motion_.forget();
    return population_.restore(state) ? Status() : unsuitable;
}

void Preserve::tick(ThreadPool& pool) {
    motion_.advance(residents(), pool);
    population_.bury(ticks() + 1);  // nothing else may depend on motion that failed
    sense();
    bite();
    feed();
    spend();
    ++world_.tick;
    population_.bury(ticks());
    population_.breed();
    population_.restock();
    world_.grow_plants();
    world_.senses.end_tick(ticks(), plants(), flesh());
    population_.feel_energy();
    record();
}

void Preserve::sense() {
    world_.senses.begin_tick();
    for (const auto& each : residents())
        world_.senses.take(each->emissions(), each->life.number);
}

void Preserve::bite() {
    bounds_.clear();
    for (const auto& each : residents())
        bounds_.push_back(grown(each->bounds(), bite_reach(*each, laws()->preserve)));
    const BiteRules rules{laws()->preserve, ticks(), world_.area.torus()};
    BroadPhase::Pair before;
    for (const BroadPhase::Pair& pair : broad_phase_.find(bounds_)) {
        const bool is_other_image = pair.first == before.first && pair.second == before.second;
        before = pair;
        if (is_other_image) continue;
        Resident& a = *residents()[pair.first];
        Resident& b = *residents()[pair.second];
        cambrian::bite(a, b, rules, world_.energy.flesh);
        cambrian::bite(b, a, rules, world_.energy.flesh);
    }
}

void Preserve::feed() {
    for (const auto& each : residents()) {
        if (each->store > 0)
            world_.energy.light += eat(*each, world_.energy.plants, world_.energy.flesh);
    }
}

void Preserve::spend() {
    for (const auto& each : residents())
        world_.energy.light += cambrian::spend(*each, laws()->preserve, ticks());
}

void Preserve::record() {
    if (ticks() % kTicksPerRow == 0) {
        CAMBRIAN_ASSERT(total_energy() == founding_energy(), "energy is neither made nor lost");
        world_.chronicle.series.push_back(row());
        world_.tally = {};
    }
    if (ticks() % kTicksPerMuseumVisit == 0) population_.remember_parent();
    if (ticks() % kTicksPerSnapshot == 0) rest();
}

void Preserve::take_snapshot() {
    world_.chronicle.snapshot = std::make_shared<const PreserveState>(save());
    snapshot_tick_ = ticks();
}

// Takes a snapshot and goes on from it.
void Preserve::rest() {
    take_snapshot();
    const Status restored = restore(*world_.chronicle.snapshot);
    CAMBRIAN_ASSERT(restored.has_value(), "a snapshot of this preserve");
    release_unused_memory();
}

}  // namespace cambrian
