#include "preserve/preserve.h"

#include "core/assert.h"
#include "core/text/number_text.h"
#include "core/unused_memory.h"
#include "math/elementary.h"
#include "preserve/life/feeding.h"
#include "preserve/world/walls.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

constexpr std::uint64_t kTicksPerRot = 6;       // 0.1 s
constexpr std::uint64_t kTicksPerRestock = 60;  // 1 s
constexpr int kGenesOfALineage = 4;             // of the body that may differ from the founder's
constexpr int kPlaceDraws = 20;                 // for a newcomer between the walls
constexpr int kPlantPlaceDraws = 20;            // for a plant of a patch, within the world
constexpr int kCrowdedPlaceDraws = 200;         // of them, if others or walls are in its way

// Uses of random streams, which are numbered by tick or by attempt.
enum Use : std::uint64_t { kGrowth = 0, kBirth = 1, kArrival = 2, kSowing = 3 };

// Energy of a newborn's store and body.
Energy store_of(const Resident& resident, const PreserveSettings& laws) {
    return energy_of(laws.birth_energy * resident.life.mass);
}
Energy body_of(const Resident& resident, const PreserveSettings& laws) {
    return energy_of(laws.body_energy * resident.life.mass);
}

constexpr double kFar = 1e4;       // m
constexpr double kFarRound = 1e9;  // m, where creatures may go round the world for all their lives

template <class Item>
std::vector<Item> checked(Result<std::vector<Item>> items) {
    CAMBRIAN_ASSERT(items.has_value(), "settings that were checked");
    return *std::move(items);
}

// Returns whether all parts of a resident are anywhere near the world, or its images.
bool strays_little(const Resident& resident, const Torus& torus) {
    const Vec3 far(torus.width > 0.0 ? kFarRound : kFar, torus.height > 0.0 ? kFarRound : kFar,
                   kFar);
    return std::all_of(
        resident.rectangles().begin(), resident.rectangles().end(),
        [&](const Rectangle& part) { return (part.center.array().abs() < far.array()).all(); });
}

}  // namespace

Preserve::Preserve(SettingsPtr settings, const EvolutionKinds& kinds,
                   std::vector<GenomePtr> founders)
    : settings_(std::move(settings)),
      laws_(settings_),
      kinds_(kinds),
      founders_(std::move(founders)),
      area_(area_of(settings_->preserve, settings_->world.environment)),
      constant_(energy_of(settings_->preserve.energy_density * area_.width * area_.height)),
      senses_(area_, settings_->world.environment),
      walls_(checked(walls_of(settings_->preserve.walls)), area_.torus()),
      patches_(checked(patches_of(settings_->preserve.patches))),
      plants_(area_.up_to(settings_->preserve.plant_height)),
      flesh_(area_.up_to(0.0)),
      ambient_(constant_),
      meetings_(area_.torus()) {
    CAMBRIAN_ASSERT(!founders_.empty(), "a preserve has founders");
    if (is_solid(settings_->preserve))
        solid_ = std::make_unique<SolidBodies>(kinds_.creature.scene, area_.torus());
}

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
    if (laws) preserve->laws_ = std::move(laws);
    if (Status restored = preserve->restore(state); !restored) return restored.error();
    preserve->snapshot_tick_ = state.tick;
    return preserve;
}

RandomStream Preserve::stream(std::uint64_t index, std::uint64_t use) const {
    return RandomStream(stream_seed(settings_->seed, index, use, Purpose::kPreserve));
}

Status Preserve::found() {
    if (const Energy plant = energy_of(settings_->preserve.plant_energy); plant > constant_) {
        return Error{fmt::format(
            "[preserve] plant-energy: one plant has {} J, but the world has {} J; expected "
            "less, or a higher energy-density",
            short_text(joules(plant)), short_text(joules(constant_)))};
    }
    const auto count = static_cast<std::size_t>(settings_->preserve.founders);
    for (std::size_t i = 0; i < count; ++i) {
        Result<std::unique_ptr<Resident>> founder = newcomer(i, "founder");
        if (!founder) return founder.error();
        if (!afford(**founder)) {
            return Error{fmt::format(
                "[preserve] founders: the energy is spent after {} of {}; expected fewer founders, "
                "or more than {} J/m^2 of energy-density",
                i, count, short_text(settings_->preserve.energy_density))};
        }
        settle(*std::move(founder));
    }
    feel_energy();
    sow();
    return {};
}

// Returns where a plant grows: anywhere or, if there are patches of light, around one of them. On
// ground, the height of a plant does not depend on light.
Vec3 Preserve::draw_bright_place(RandomStream& draws) const {
    const auto draw_y = [&] {
        return area_.has_ground ? settings_->preserve.plant_height * draws.uniform()
                                : area_.height * (draws.uniform() - 0.5);
    };
    for (int draw = 0; draw < kPlantPlaceDraws && !patches_.empty(); ++draw) {
        const LightPatch& patch = patches_[draws.below(patches_.size())];
        const double x = draws.gauss();
        const double y = draws.gauss();
        Vec3 place = patch.center + patch.spread * Vec3(x, y, 0.0);
        if (area_.has_ground) place.y() = draw_y();
        if (area_.holds(place, 0.0)) return place;
    }
    const double x = area_.width * (draws.uniform() - 0.5);
    return {x, draw_y(), 0.0};
}

void Preserve::add_plant(RandomStream& draws) {
    const Energy plant = energy_of(laws_->preserve.plant_energy);
    plants_.add(draw_bright_place(draws), plant);
    ambient_ -= plant;
}

// Turns half of the light into plants, so that founders do not starve before any grow.
void Preserve::sow() {
    RandomStream draws = stream(0, kSowing);
    const Energy after = ambient_ / 2;
    const Energy plant = energy_of(settings_->preserve.plant_energy);
    while (ambient_ - plant >= after)
        add_plant(draws);
}

std::uint64_t Preserve::newcomer_uid() const {
    return stream_seed(settings_->seed, next_number_, kArrival, Purpose::kPreserve);
}

// Returns a copy of one of the founders at a random place, not yet paid.
Result<std::unique_ptr<Resident>> Preserve::newcomer(std::size_t place, std::string method) {
    const GenomePtr& genome = founders_[place % founders_.size()];
    Life life{.number = next_number_, .method = std::move(method), .genome = genome, .born = tick_};
    life.uid = newcomer_uid();
    const std::size_t which = place % founders_.size() + 1;
    auto grown = Resident::grow(std::move(life), kinds_.creature, *settings_, senses_);
    if (!grown)
        return Error{fmt::format("founder {} cannot live: {}", which, grown.error().message)};
    Resident& resident = **grown;
    if (!resident.can_move()) {
        return Error{
            fmt::format("founder {} cannot move; expected creatures with a joint that "
                        "follows more than constants",
                        which)};
    }
    RandomStream draws = stream(next_number_, kArrival);
    const bool is_crowded = solid_ || !walls_.lines().empty();
    bool fits = false;  // between the walls
    for (int draw = 0; draw < (is_crowded ? kCrowdedPlaceDraws : kPlaceDraws); ++draw) {
        const double x = area_.width * (draws.uniform() - 0.5);
        const double y = area_.height * (draws.uniform() - 0.5);
        resident.place(room().footing(Vec3(x, y, 0.0), resident), Vec3::Zero());
        if (!area_.holds(resident.center(), resident.radius())) continue;
        if (room().is_free(resident.bounds(), resident)) return grown;
        fits = true;
    }
    resident.place(room().footing(Vec3::Zero(), resident), Vec3::Zero());
    if (area_.holds(resident.center(), resident.radius()) &&
        room().is_free(resident.bounds(), resident))
        return grown;
    if (fits) {
        return Error{fmt::format(
            "no place is left for founder {}; expected fewer founders, fewer walls or a "
            "larger world",
            place + 1)};
    }
    return Error{
        fmt::format("founder {} is too large for the world: it needs {} m, the world has "
                    "{} m x {} m",
                    which, short_text(2.0 * resident.radius()), short_text(area_.width),
                    short_text(area_.height))};
}

Energy Preserve::price_of(const Resident& resident) const {
    return store_of(resident, laws_->preserve) + body_of(resident, laws_->preserve);
}

// Makes sure that the light can pay a newcomer. If it has too little energy, plants become light
// again; otherwise a world full of plants in which nobody is left would stay empty. Returns false
// and changes nothing if all plants would not do.
bool Preserve::afford(const Resident& resident) {
    const Energy missing = price_of(resident) - ambient_;
    if (missing <= 0) return true;
    if (plants_.energy() < missing) return false;
    ambient_ += plants_.take_at_least(missing);
    return true;
}

// Adds a newcomer, which the light pays.
void Preserve::settle(std::unique_ptr<Resident> resident) {
    resident->store = store_of(*resident, laws_->preserve);
    resident->body = body_of(*resident, laws_->preserve);
    ambient_ -= resident->store + resident->body;
    join_lineage(*resident, nullptr);
    resident->last_birth = tick_;
    ++next_number_;
    resident->life.x = resident->center().x();
    resident->life.y = resident->center().y();
    chronicle_.born.push_back(resident->life);
    take_in(std::move(resident));
}

void Preserve::take_in(std::unique_ptr<Resident> resident) {
    resident->scene().set_fixed_boxes(walls_.boxes());
    if (laws_ != settings_) resident->scene().set_environment(laws_->world.environment);
    resident->settle();
    residents_.push_back(std::move(resident));
}

void Preserve::join_lineage(Resident& resident, const Resident* parent) {
    Life& life = resident.life;
    life.lineage = parent == nullptr ? life.number : parent->life.lineage;
    if (parent != nullptr &&
        differing_body_genes(*life.genome, *lineages_.at(life.lineage)) > kGenesOfALineage)
        life.lineage = life.number;
    lineages_.try_emplace(life.lineage, life.genome);
}

Energy Preserve::total_energy() const {
    Energy total = ambient_ + plants_.energy() + flesh_.energy();
    for (const auto& each : residents_)
        total += each->store + each->body;
    return total;
}

SolidCounts Preserve::solid_counts() const {
    return solid_ ? solid_->counts() : SolidCounts{};
}

SeriesRow Preserve::row() const {
    return series_row(tick_, residents_, ambient_, plants_, flesh_, tally_);
}

Chronicle Preserve::take_chronicle() {
    return std::exchange(chronicle_, {});
}

PreserveState Preserve::save() const {
    PreserveState state;
    state.tick = tick_;
    state.next_number = next_number_;
    state.attempts = attempts_;
    state.restocked = restocked_;
    state.ambient = ambient_;
    state.plants.assign(plants_.all().begin(), plants_.all().end());
    state.flesh.assign(flesh_.all().begin(), flesh_.all().end());
    state.scents = senses_.save();
    state.walls = walls_.lines();
    for (const auto& [number, genome] : lineages_)
        state.lineages.push_back({number, genome});
    for (const auto& each : residents_)
        state.residents.push_back(each->save());
    return state;
}

// Returns whether the energies of a state add up to the constant of the world.
bool Preserve::adds_up(const PreserveState& state) const {
    Energy sum = 0;
    bool sound = true;
    const auto add = [&](Energy energy) {
        sound = sound && energy >= 0 && energy <= constant_ - sum;
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
    return sound && sum == constant_;
}

Status Preserve::restore(const PreserveState& state) {
    const Error unsuitable{"the snapshot does not belong to these settings"};
    if (!adds_up(state)) return unsuitable;
    for (const auto* field : {&state.scents.scent, &state.scents.plants, &state.scents.flesh}) {
        if (field->any && field->cells.size() != senses_.cells()) return unsuitable;
    }
    if (state.walls.size() > static_cast<std::size_t>(kMostFixedBoxes)) return unsuitable;
    for (const WallLine& wall : state.walls) {
        if (!check_wall(wall, area_)) return unsuitable;
    }
    tick_ = state.tick;
    next_number_ = state.next_number;
    attempts_ = state.attempts;
    restocked_ = state.restocked;
    ambient_ = state.ambient;
    plants_.replace(state.plants);
    flesh_.replace(state.flesh);
    senses_.restore(state.scents);
    lineages_.clear();
    for (const Lineage& lineage : state.lineages)
        lineages_.emplace(lineage.number, lineage.genome);
    residents_.clear();
    walls_.replace(state.walls);
    if (solid_) solid_->forget();
    std::uint64_t before = 0;
    for (const ResidentState& each : state.residents) {
        if (each.life.number <= before || each.life.number >= next_number_ ||
            !lineages_.contains(each.life.lineage) || each.life.born > tick_)
            return unsuitable;
        before = each.life.number;
        auto grown = Resident::grow(each.life, kinds_.creature, *settings_, senses_);
        if (!grown || !(*grown)->restore(each) || !strays_little(**grown, area_.torus()))
            return unsuitable;
        take_in(std::move(*grown));
    }
    feel_energy();
    return {};
}

void Preserve::tick(ThreadPool& pool) {
    live(pool);
    bury(tick_ + 1);  // nothing else may depend on motion that failed
    sense();
    bite();
    feed();
    spend();
    ++tick_;
    bury(tick_);
    breed();
    restock();
    grow_plants();
    senses_.end_tick(tick_, plants_, flesh_);
    feel_energy();
    record();
}

void Preserve::live(ThreadPool& pool) {
    make_workspaces(pool.workers());
    if (solid_) return move_solid(pool);
    pool.parallel_for(residents_.size(), [&](std::size_t index, std::size_t worker) {
        Resident& resident = *residents_[index];
        if (walls_have_images()) surround(resident, resident.bounds());
        resident.live(workspaces_[worker], area_);
    });
}

void Preserve::move_solid(ThreadPool& pool) {
    std::vector<SolidBody> bodies;
    for (const auto& each : residents_)
        bodies.push_back({.number = each->life.number,
                          .scene = &each->scene(),
                          .bounds = each->bounds(),
                          .fastest = each->fastest(),
                          .pulls = kPullsOfWalls});
    SolidActs acts{
        .begin = [&](std::size_t index) { residents_[index]->act(area_); },
        .end = [&](std::size_t index) { residents_[index]->end_tick(bodies[index].status); }};
    if (walls_have_images()) {
        acts.surround = [&](std::size_t index, const Bounds& bounds) {
            surround(*residents_[index], bounds);
        };
    }
    solid_->advance(bodies, kBrainTick, acts, workspaces_, pool);
}

// Gives a resident the images of the walls that bodies within these bounds can reach. Where edges
// do not meet, all have the same walls.
void Preserve::surround(Resident& resident, const Bounds& bounds) const {
    resident.surround_by(walls_.boxes_around(bounds));
}

void Preserve::make_workspaces(std::size_t workers) {
    workspaces_.resize(std::max(workspaces_.size(), workers));
    for (std::size_t worker = 0; worker < workers && !residents_.empty(); ++worker) {
        if (workspaces_[worker]) continue;
        const auto scene =
            kinds_.creature.scene.make(residents_.front()->phenotype().plan,
                                       settings_->world.environment, settings_->world.scene);
        CAMBRIAN_ASSERT(scene.has_value(), "a resident's body suits physics");
        workspaces_[worker] = (*scene)->take_workspace();
    }
}

void Preserve::sense() {
    senses_.begin_tick();
    for (const auto& each : residents_)
        senses_.take(each->emissions(), each->life.number);
}

void Preserve::bite() {
    bounds_.clear();
    for (const auto& each : residents_)
        bounds_.push_back(grown(each->bounds(), bite_reach(*each, laws_->preserve)));
    const BiteRules rules{laws_->preserve, tick_, area_.torus()};
    Meetings::Pair before;
    for (const Meetings::Pair& pair : meetings_.find(bounds_)) {
        const bool is_other_image = pair.first == before.first && pair.second == before.second;
        before = pair;
        if (is_other_image) continue;
        Resident& a = *residents_[pair.first];
        Resident& b = *residents_[pair.second];
        cambrian::bite(a, b, rules, flesh_);
        cambrian::bite(b, a, rules, flesh_);
    }
}

void Preserve::feed() {
    for (const auto& each : residents_) {
        if (each->store > 0) ambient_ += eat(*each, plants_, flesh_);
    }
}

void Preserve::spend() {
    for (const auto& each : residents_)
        ambient_ += cambrian::spend(*each, laws_->preserve, tick_);
}

// Removes those whose store is empty, or whose motion failed. Their energy becomes flesh.
void Preserve::bury(std::uint64_t tick) {
    for (const auto& each : residents_) {
        Life& life = each->life;
        if (each->is_broken()) {
            life.cause = DeathCause::kBrokenPhysics;
            ++tally_.broken_physics;
        } else if (each->store > 0) {
            continue;
        } else if (each->bitten) {
            life.cause = DeathCause::kEaten;
            ++tally_.eaten;
        } else {
            life.cause = DeathCause::kHunger;
            ++tally_.hunger;
        }
        end_life(*each, tick);
    }
    if (std::erase_if(residents_, [](const auto& each) { return each->life.died != 0; }) > 0)
        forget_lineages();
}

// Turns the energy of a resident into flesh and notes the death, whose cause must be set.
void Preserve::end_life(Resident& resident, std::uint64_t tick) {
    Life& life = resident.life;
    life.died = tick;
    const Vec3 place = area_.nearest(resident.is_broken() ? resident.rectangles().front().center
                                                          : resident.center());
    life.x = place.x();
    life.y = place.y();
    decay_to_flesh(resident, flesh_);
    chronicle_.died.push_back(life);
}

void Preserve::forget_lineages() {
    std::erase_if(lineages_, [&](const auto& lineage) {
        return std::none_of(residents_.begin(), residents_.end(),
                            [&](const auto& each) { return each->life.lineage == lineage.first; });
    });
}

void Preserve::breed() {
    const PreserveSettings& laws = laws_->preserve;
    const auto grown = residents_.size();
    for (std::size_t i = 0; i < grown; ++i) {
        if (residents_.size() >= static_cast<std::size_t>(laws.max_population)) return;
        Resident& parent = *residents_[i];
        const double since = static_cast<double>(tick_ - parent.last_birth) * kBrainTick;
        if (since < laws.birth_interval) continue;
        if (parent.store > 2 * store_of(parent, laws) + body_of(parent, laws)) try_birth(parent);
    }
}

// A child that costs more than its parent can spare is not born; the next attempt is another one.
void Preserve::try_birth(Resident& parent) {
    const PreserveSettings& laws = laws_->preserve;
    parent.last_birth = tick_;
    RandomStream draws = stream(++attempts_, kBirth);
    Life life = conceive(parent, residents_, *laws_, kinds_, attempts_, tick_, draws);
    life.number = next_number_;
    auto child = Resident::grow(std::move(life), kinds_.creature, *settings_, senses_);
    if (!child) return;
    const Energy store = store_of(**child, laws);
    const Energy body = body_of(**child, laws);
    if (parent.store <= 2 * store + body) return;
    if (!(*child)->can_move()) {
        parent.store -= store + body;
        flesh_.add(parent.center(), store + body);
        ++tally_.stillborn;
        return;
    }
    (*child)->store = store;
    (*child)->body = body;
    bear(parent, std::move(*child), draws);
}

// Places the child beside its parent, at the first of 16 places between the walls, on the same side
// of those that were drawn. Where edges meet, it is born in the area, wherever its parent went.
void Preserve::bear(Resident& parent, std::unique_ptr<Resident> child, RandomStream& stream) {
    const std::size_t first = stream.below(kBirthPlaces);
    const Vec3 velocity = area_.has_ground ? Vec3(Vec3::Zero()) : parent.velocity();
    for (std::size_t i = 0; i < kBirthPlaces; ++i) {
        const Vec3 center = room().birth_place(parent, *child, {first, i});
        if (!area_.holds(center, child->radius()) || walls_.separate(parent.center(), center))
            continue;
        const Vec3 place = area_.torus().shortest(center);
        child->place(place, velocity);
        if (!room().is_free(child->bounds(), *child)) continue;
        parent.store -= child->store + child->body;
        ++parent.life.children;
        child->life.x = place.x();
        child->life.y = place.y();
        child->last_birth = tick_;
        join_lineage(*child, &parent);
        ++next_number_;
        ++tally_.births;
        chronicle_.born.push_back(child->life);
        const std::uint64_t lineage = child->life.lineage;
        take_in(std::move(child));
        remember_lineage(lineage);
        return;
    }
}

// Takes the founder of a lineage into the museum when it becomes a large one.
void Preserve::remember_lineage(std::uint64_t lineage) {
    if (living_members(residents_, lineage) != kMembersForMuseum) return;
    chronicle_.museum.push_back(
        {lineage, tick_, museum_reason::kLineage, kMembersForMuseum, lineages_.at(lineage)});
}

void Preserve::remember_parent() {
    const Resident* parent = most_fertile(residents_);
    if (parent == nullptr) return;
    const Life& life = parent->life;
    chronicle_.museum.push_back(
        {life.number, tick_, museum_reason::kChildren, life.children, parent->genome()});
}

void Preserve::restock() {
    const auto floor = static_cast<std::size_t>(laws_->preserve.restock);
    if (tick_ % kTicksPerRestock != 0) return;
    while (residents_.size() < floor) {
        Result<std::unique_ptr<Resident>> arriving = newcomer(restocked_, "restock");
        if (!arriving || !afford(**arriving)) return;
        chronicle_.interventions.push_back({tick_, intervention::kRestock, next_number_});
        settle(*std::move(arriving));
        ++restocked_;
        ++tally_.restocked;
    }
}

// Light becomes plants, and flesh light.
void Preserve::grow_plants() {
    const PreserveSettings& laws = laws_->preserve;
    const Energy plant = energy_of(laws.plant_energy);
    const double expected = joules(ambient_) / (laws.growth_time * laws.plant_energy) * kBrainTick;
    RandomStream draws = stream(tick_, kGrowth);
    auto count = static_cast<std::uint64_t>(expected);
    if (draws.chance(expected - static_cast<double>(count))) ++count;
    for (; count > 0 && ambient_ >= plant; --count)
        add_plant(draws);
    if (tick_ % kTicksPerRot != 0) return;
    const double time = kTicksPerRot * kBrainTick;
    ambient_ += flesh_.rot(1.0 - exponential(-logarithm(2.0) * time / laws.flesh_half_life));
}

void Preserve::feel_energy() {
    for (const auto& each : residents_) {
        const Energy birth = store_of(*each, laws_->preserve);
        each->feel(birth > 0 ? joules(each->store) / joules(birth) : 0.0);
    }
}

void Preserve::record() {
    if (tick_ % kTicksPerRow == 0) {
        CAMBRIAN_ASSERT(total_energy() == constant_, "energy is neither made nor lost");
        chronicle_.series.push_back(row());
        tally_ = {};
    }
    if (tick_ % kTicksPerMuseumVisit == 0) remember_parent();
    if (tick_ % kTicksPerSnapshot == 0) rest();
}

void Preserve::take_snapshot() {
    chronicle_.snapshot = std::make_shared<const PreserveState>(save());
    snapshot_tick_ = tick_;
}

// Takes a snapshot and goes on from it.
void Preserve::rest() {
    take_snapshot();
    const Status restored = restore(*chronicle_.snapshot);
    CAMBRIAN_ASSERT(restored.has_value(), "a snapshot of this preserve");
    release_unused_memory();
}

}  // namespace cambrian
