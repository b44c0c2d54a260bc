#include "preserve/population.h"

#include "core/assert.h"
#include "core/text/number_text.h"
#include "core/text/pretty_text.h"
#include "preserve/life/feeding.h"
#include "preserve/museum.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

constexpr std::uint64_t kTicksPerRestock = 60;  // 1 s
constexpr int kGenesOfALineage = 4;             // of the body that may differ from the founder's
constexpr int kPlaceDraws = 20;                 // for a newcomer between the walls
constexpr int kCrowdedPlaceDraws = 200;         // of them, if others or walls are in its way
constexpr const char* kNoRoom = "There is no room: other creatures are in the way.";

// Energy of a newborn's store and body.
Energy store_of(const Resident& resident, const PreserveSettings& laws) {
    return energy_of(laws.birth_energy * resident.life.mass);
}
Energy body_of(const Resident& resident, const PreserveSettings& laws) {
    return energy_of(laws.body_energy * resident.life.mass);
}

Error is_not_alive(std::uint64_t number) {
    return {fmt::format("creature {} is not alive", number)};
}

std::string joules_text(Energy energy) {
    return measured(joules(energy), "J");
}

constexpr double kFar = 1e4;       // m
constexpr double kFarRound = 1e9;  // m, where creatures may go round the world for all their lives

// Returns whether all parts of a resident are anywhere near the world, or its images.
bool strays_little(const Resident& resident, const Torus& torus) {
    const Vec3 far(torus.width > 0.0 ? kFarRound : kFar, torus.height > 0.0 ? kFarRound : kFar,
                   kFar);
    return std::all_of(
        resident.rectangles().begin(), resident.rectangles().end(),
        [&](const Rectangle& part) { return (part.center.array().abs() < far.array()).all(); });
}

}  // namespace

Population::Population(PreserveWorld& world, std::vector<GenomePtr> founders)
    : world_(world), founders_(std::move(founders)) {
    CAMBRIAN_ASSERT(!founders_.empty(), "a preserve has founders");
}

Room Population::room() const {
    return {world_.area, world_.walls, residents_, is_solid(world_.settings->preserve)};
}

Result<std::unique_ptr<Resident>> Population::grow(Life life) const {
    return Resident::grow(std::move(life), world_.kinds.creature, *world_.settings, world_.senses);
}

// Returns the life of the next creature, if it comes from elsewhere.
Life Population::arriving(const GenomePtr& genome, std::string method) const {
    Life life{
        .number = next_number_, .method = std::move(method), .genome = genome, .born = world_.tick};
    life.uid = world_.seed(next_number_, PreserveUse::kArrival);
    return life;
}

Status Population::found() {
    const auto count = static_cast<std::size_t>(world_.settings->preserve.founders);
    for (std::size_t i = 0; i < count; ++i) {
        Result<std::unique_ptr<Resident>> founder = newcomer(i, "founder");
        if (!founder) return founder.error();
        if (!world_.energy.afford(price_of(**founder))) {
            return Error{fmt::format(
                "[preserve] founders: the energy is spent after {} of {}; expected fewer founders, "
                "or more than {} J/m^2 of energy-density",
                i, count, short_text(world_.settings->preserve.energy_density))};
        }
        welcome(*std::move(founder));
    }
    feel_energy();
    return {};
}

// Returns a copy of one of the founders at a random place, not yet paid.
Result<std::unique_ptr<Resident>> Population::newcomer(std::size_t place, std::string method) {
    const std::size_t which = place % founders_.size() + 1;
    auto grown = grow(arriving(founders_[which - 1], std::move(method)));
    if (!grown)
        return Error{fmt::format("founder {} cannot live: {}", which, grown.error().message)};
    Resident& resident = **grown;
    if (!resident.can_move()) {
        return Error{
            fmt::format("founder {} cannot move; expected creatures with a joint that "
                        "follows more than constants",
                        which)};
    }
    RandomStream draws = world_.stream(next_number_, PreserveUse::kArrival);
    const bool is_crowded = is_solid(world_.settings->preserve) || !world_.walls.lines().empty();
    bool fits = false;  // between the walls
    for (int draw = 0; draw < (is_crowded ? kCrowdedPlaceDraws : kPlaceDraws); ++draw) {
        const double x = world_.area.width * (draws.uniform() - 0.5);
        const double y = world_.area.height * (draws.uniform() - 0.5);
        resident.place(room().footing(Vec3(x, y, 0.0), resident), Vec3::Zero());
        if (!world_.area.holds(resident.center(), resident.radius())) continue;
        if (room().is_free(resident.bounds(), resident)) return grown;
        fits = true;
    }
    resident.place(room().footing(Vec3::Zero(), resident), Vec3::Zero());
    if (world_.area.holds(resident.center(), resident.radius()) &&
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
                    which, short_text(2.0 * resident.radius()), short_text(world_.area.width),
                    short_text(world_.area.height))};
}

// Adds a newcomer, which the light pays.
void Population::welcome(std::unique_ptr<Resident> resident) {
    resident->store = store_of(*resident, world_.laws->preserve);
    resident->body = body_of(*resident, world_.laws->preserve);
    world_.energy.light -= resident->store + resident->body;
    join_lineage(*resident, nullptr);
    resident->last_birth = world_.tick;
    ++next_number_;
    resident->life.x = resident->center().x();
    resident->life.y = resident->center().y();
    world_.chronicle.born.push_back(resident->life);
    take_in(std::move(resident));
}

void Population::take_in(std::unique_ptr<Resident> resident) {
    resident->scene().set_fixed_boxes(world_.walls.boxes());
    if (world_.laws != world_.settings) resident->scene().set_environment(world_.environment());
    resident->give_up_workspace();
    CAMBRIAN_TICK_ASSERT(
        residents_.empty() || residents_.back()->life.number < resident->life.number,
        "numbers ascend, so that parents come before children");
    residents_.push_back(std::move(resident));
}

void Population::join_lineage(Resident& resident, const Resident* parent) {
    Life& life = resident.life;
    life.lineage = parent == nullptr ? life.number : parent->life.lineage;
    if (parent != nullptr &&
        differing_body_genes(*life.genome, *lineages_.at(life.lineage)) > kGenesOfALineage)
        life.lineage = life.number;
    lineages_.try_emplace(life.lineage, life.genome);
}

// Removes those whose store is empty, or whose motion failed. Their energy becomes flesh.
void Population::bury(std::uint64_t tick) {
    for (const auto& each : residents_) {
        Life& life = each->life;
        if (each->is_broken()) {
            life.cause = DeathCause::kBrokenPhysics;
            ++world_.tally.broken_physics;
        } else if (each->store > 0) {
            continue;
        } else if (each->bitten) {
            life.cause = DeathCause::kEaten;
            ++world_.tally.eaten;
        } else {
            life.cause = DeathCause::kHunger;
            ++world_.tally.hunger;
        }
        end_life(*each, tick);
    }
    if (std::erase_if(residents_, [](const auto& each) { return each->life.died != 0; }) > 0)
        forget_lineages();
}

// Turns the energy of a resident into flesh and notes the death, whose cause must be set.
void Population::end_life(Resident& resident, std::uint64_t tick) {
    Life& life = resident.life;
    life.died = tick;
    const Vec3 place = world_.area.nearest(
        resident.is_broken() ? resident.rectangles().front().center : resident.center());
    life.x = place.x();
    life.y = place.y();
    decay_to_flesh(resident, world_.energy.flesh);
    world_.chronicle.died.push_back(life);
}

void Population::forget_lineages() {
    std::erase_if(lineages_, [&](const auto& lineage) {
        return std::none_of(residents_.begin(), residents_.end(),
                            [&](const auto& each) { return each->life.lineage == lineage.first; });
    });
}

void Population::breed() {
    const PreserveSettings& laws = world_.laws->preserve;
    const auto grown = residents_.size();
    for (std::size_t i = 0; i < grown; ++i) {
        if (residents_.size() >= static_cast<std::size_t>(laws.max_population)) return;
        Resident& parent = *residents_[i];
        const double since = static_cast<double>(world_.tick - parent.last_birth) * kBrainTick;
        if (since < laws.birth_interval) continue;
        if (parent.store > 2 * store_of(parent, laws) + body_of(parent, laws)) try_birth(parent);
    }
}

// A child that costs more than its parent can spare is not born; the next attempt is another one.
void Population::try_birth(Resident& parent) {
    const PreserveSettings& laws = world_.laws->preserve;
    parent.last_birth = world_.tick;
    RandomStream draws = world_.stream(++attempts_, PreserveUse::kBirth);
    Life life =
        conceive(parent, residents_, *world_.laws, world_.kinds, attempts_, world_.tick, draws);
    life.number = next_number_;
    auto child = grow(std::move(life));
    if (!child) return;
    const Energy store = store_of(**child, laws);
    const Energy body = body_of(**child, laws);
    if (parent.store <= 2 * store + body) return;
    if (!(*child)->can_move()) {
        parent.store -= store + body;
        world_.energy.flesh.add(parent.center(), store + body);
        ++world_.tally.stillborn;
        return;
    }
    (*child)->store = store;
    (*child)->body = body;
    bear(parent, std::move(*child), draws);
}

// Places the child beside its parent, at the first of 16 places between the walls, on the same side
// of those that were drawn. Where edges meet, it is born in the area, wherever its parent went.
void Population::bear(Resident& parent, std::unique_ptr<Resident> child, RandomStream& stream) {
    const std::size_t first = stream.below(kBirthPlaces);
    const Vec3 velocity = world_.area.has_ground ? Vec3(Vec3::Zero()) : parent.velocity();
    for (std::size_t i = 0; i < kBirthPlaces; ++i) {
        const Vec3 center = room().birth_place(parent, *child, {first, i});
        if (!world_.area.holds(center, child->radius()) ||
            world_.walls.separate(parent.center(), center))
            continue;
        const Vec3 place = world_.area.torus().shortest(center);
        child->place(place, velocity);
        if (!room().is_free(child->bounds(), *child)) continue;
        CAMBRIAN_TICK_ASSERT(world_.area.holds(child->center(), 0.0), "born within the area");
        parent.store -= child->store + child->body;
        ++parent.life.children;
        child->life.x = place.x();
        child->life.y = place.y();
        child->last_birth = world_.tick;
        join_lineage(*child, &parent);
        ++next_number_;
        ++world_.tally.births;
        world_.chronicle.born.push_back(child->life);
        const std::uint64_t lineage = child->life.lineage;
        take_in(std::move(child));
        remember_lineage(lineage);
        return;
    }
}

// Takes the founder of a lineage into the museum when it becomes a large one.
void Population::remember_lineage(std::uint64_t lineage) {
    if (living_members(residents_, lineage) != kMembersForMuseum) return;
    world_.chronicle.museum.push_back(
        {lineage, world_.tick, museum_reason::kLineage, kMembersForMuseum, lineages_.at(lineage)});
}

void Population::remember_parent() {
    const Resident* parent = most_fertile(residents_);
    if (parent == nullptr) return;
    const Life& life = parent->life;
    world_.chronicle.museum.push_back(
        {life.number, world_.tick, museum_reason::kChildren, life.children, parent->genome()});
}

void Population::restock() {
    const auto floor = static_cast<std::size_t>(world_.laws->preserve.restock);
    if (world_.tick % kTicksPerRestock != 0) return;
    while (residents_.size() < floor) {
        Result<std::unique_ptr<Resident>> arriving = newcomer(restocked_, "restock");
        if (!arriving || !world_.energy.afford(price_of(**arriving))) return;
        world_.chronicle.interventions.push_back(
            {world_.tick, intervention::kRestock, next_number_});
        welcome(*std::move(arriving));
        ++restocked_;
        ++world_.tally.restocked;
    }
}

void Population::feel_energy() {
    for (const auto& each : residents_) {
        const Energy birth = store_of(*each, world_.laws->preserve);
        each->feel(birth > 0 ? joules(each->store) / joules(birth) : 0.0);
    }
}

Energy Population::price_of(const Resident& resident) const {
    return store_of(resident, world_.laws->preserve) + body_of(resident, world_.laws->preserve);
}

// Adds a creature at a place, which the light pays. Returns its number.
Result<std::uint64_t> Population::admit(const GenomePtr& genome, const Vec3& place) {
    if (!genome) return Error{"a creature to add has no genotype"};
    auto grown = grow(arriving(genome, "added"));
    if (!grown)
        return Error{fmt::format("The creature cannot live here: {}.", grown.error().message)};
    Resident& resident = **grown;
    if (!resident.can_move())
        return Error{
            "The creature cannot live here: none of its joints follows more than constants."};
    const std::optional<Vec3> center = room().nearest(place, resident);
    if (!center) return Error{kNoRoom};
    if (!world_.area.holds(*center, resident.radius()))
        return Error{"The creature is too large for the world."};
    if (!world_.energy.afford(price_of(resident))) {
        const Energy left = world_.energy.light + world_.energy.plants.energy();
        return Error{
            fmt::format("The light and the plants have {} left, and the creature costs {}.",
                        joules_text(left), joules_text(price_of(resident)))};
    }
    resident.place(*center, Vec3::Zero());
    const std::uint64_t number = next_number_;
    welcome(*std::move(grown));
    feel_energy();
    return number;
}

// Moves all creatures that these walls meet, or none.
Status Population::make_way(const DrawnWalls& walls) {
    std::vector<Resident*> movers;
    std::vector<Vec3> places;
    std::vector<Bounds> taken;
    const Room room(world_.area, walls, residents_, is_solid(world_.settings->preserve));
    for (const auto& each : residents_) {
        if (!walls.meet(each->rectangles())) continue;
        const std::optional<Vec3> place = room.nearest(each->center(), *each, taken);
        if (!place) return Error{"There is no room for the creatures in the way of this wall."};
        movers.push_back(each.get());
        places.push_back(*place);
        taken.push_back(moved(each->bounds(), *place - each->center()));
    }
    for (std::size_t i = 0; i < movers.size(); ++i)
        movers[i]->place(places[i], Vec3::Zero());
    return {};
}

// Returns where a creature is among the living.
Residents::iterator Population::find(std::uint64_t number) {
    return std::find_if(residents_.begin(), residents_.end(),
                        [&](const auto& each) { return each->life.number == number; });
}

Status Population::move(std::uint64_t number, const Vec3& place) {
    const auto found = find(number);
    if (found == residents_.end()) return is_not_alive(number);
    const std::optional<Vec3> free = room().nearest(place, **found);
    if (!free) return Error{kNoRoom};
    (*found)->place(*free, Vec3::Zero());
    return {};
}

Status Population::remove(std::uint64_t number) {
    const auto found = find(number);
    if (found == residents_.end()) return is_not_alive(number);
    (*found)->life.cause = DeathCause::kRemoved;
    end_life(**found, std::max<std::uint64_t>(1, world_.tick));  // 0 means alive
    residents_.erase(found);
    forget_lineages();
    return {};
}

void Population::save(PreserveState& state) const {
    state.next_number = next_number_;
    state.attempts = attempts_;
    state.restocked = restocked_;
    for (const auto& [number, genome] : lineages_)
        state.lineages.push_back({number, genome});
    for (const auto& each : residents_)
        state.residents.push_back(each->save());
}

bool Population::restore(const PreserveState& state) {
    next_number_ = state.next_number;
    attempts_ = state.attempts;
    restocked_ = state.restocked;
    lineages_.clear();
    for (const Lineage& lineage : state.lineages)
        lineages_.emplace(lineage.number, lineage.genome);
    residents_.clear();
    std::uint64_t before = 0;
    for (const ResidentState& each : state.residents) {
        if (each.life.number <= before || each.life.number >= next_number_ ||
            !lineages_.contains(each.life.lineage) || each.life.born > world_.tick)
            return false;
        before = each.life.number;
        auto grown = grow(each.life);
        if (!grown || !(*grown)->restore(each) || !strays_little(**grown, world_.area.torus()))
            return false;
        take_in(std::move(*grown));
    }
    feel_energy();
    return true;
}

}  // namespace cambrian
