// What people do to a preserve between two ticks (preserve/README.md 8).

#include "core/text/pretty_text.h"
#include "math/elementary.h"
#include "preserve/life/feeding.h"
#include "preserve/preserve.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cambrian {
namespace {

constexpr std::uint64_t kPlantsOfAMeal = 10;
constexpr double kMealRadius = 0.6;  // m
constexpr const char* kNoRoom = "There is no room: other creatures are in the way.";
constexpr double kGoldenTurn = 2.399963230;  // rad, between two plants of a spiral

// Returns the place nearest to the one asked for at which a circle is between the walls.
Vec3 place_between_walls(const WalledArea& area, const Vec3& asked, double radius) {
    const double x = std::max(0.5 * area.width - radius, 0.0);
    const double y = std::max(0.5 * area.height - radius, 0.0);
    return {std::clamp(asked.x(), -x, x), std::clamp(asked.y(), -y, y), 0.0};
}

std::string joules_text(Energy energy) {
    return measured(joules(energy), "J");
}

}  // namespace

Result<std::uint64_t> Preserve::intervene(Intervention asked) {
    if (!std::isfinite(asked.x) || !std::isfinite(asked.y))
        return Error{"the place of an intervention is not finite"};
    asked.tick = tick_;
    Result<std::uint64_t> number = carry_out(asked);
    if (!number) return number;
    asked.number = *number;
    chronicle_.interventions.push_back(std::move(asked));
    return number;
}

Result<std::uint64_t> Preserve::carry_out(const Intervention& asked) {
    const Vec3 place(asked.x, asked.y, 0.0);
    if (asked.what == intervention::kRest) {
        rest();
        return asked.number;
    }
    if (asked.what == intervention::kFeed) return serve(place);
    if (asked.what == intervention::kAdd) return admit(asked.genome, place);
    const auto found = std::find_if(residents_.begin(), residents_.end(), [&](const auto& each) {
        return each->life.number == asked.number;
    });
    if (found == residents_.end())
        return Error{fmt::format("creature {} is not alive", asked.number)};
    if (asked.what == intervention::kMove) {
        const std::optional<Vec3> room = room_near(place, **found);
        if (!room) return Error{kNoRoom};
        (*found)->place(*room, Vec3::Zero());
        return asked.number;
    }
    if (asked.what != intervention::kRemove)
        return Error{fmt::format("the intervention \"{}\" is unknown", asked.what)};
    (*found)->life.cause = DeathCause::kRemoved;
    end_life(**found, std::max<std::uint64_t>(1, tick_));  // 0 means alive
    residents_.erase(found);
    forget_lineages();
    return asked.number;
}

// Returns the first place with room, between the walls, on a spiral around the one asked for.
std::optional<Vec3> Preserve::room_near(const Vec3& asked, const Resident& resident) const {
    constexpr int kPlaces = 64;
    for (int i = 0; i < kPlaces; ++i) {
        const SineCosine turn = sine_cosine(kGoldenTurn * static_cast<double>(i));
        const double distance = resident.radius() * std::sqrt(static_cast<double>(i));
        const Vec3 place = place_between_walls(
            area_, asked + distance * Vec3(turn.cosine, turn.sine, 0.0), resident.radius());
        const Vec3 shift = place - resident.center();
        const Bounds bounds = resident.bounds();
        if (is_free({bounds.low + shift, bounds.high + shift}, resident)) return place;
    }
    return std::nullopt;
}

// Adds plants around a place, which the light pays. Returns their number.
Result<std::uint64_t> Preserve::serve(const Vec3& place) {
    const Energy plant = energy_of(settings_->preserve.plant_energy);
    std::uint64_t count = 0;
    for (; count < kPlantsOfAMeal && ambient_ >= plant; ++count) {
        const auto index = static_cast<double>(count);
        const double radius = kMealRadius * std::sqrt(index / kPlantsOfAMeal);
        const SineCosine turn = sine_cosine(kGoldenTurn * index);
        plants_.add(place + radius * Vec3(turn.cosine, turn.sine, 0.0), plant);
        ambient_ -= plant;
    }
    if (count == 0) {
        return Error{
            fmt::format("There is no light left to pay for a plant ({}); it returns as creatures "
                        "move and flesh rots.",
                        joules_text(plant))};
    }
    return count;
}

// Adds a creature at a place, which the light pays. Returns its number.
Result<std::uint64_t> Preserve::admit(const GenomePtr& genome, const Vec3& place) {
    if (!genome) return Error{"a creature to add has no genotype"};
    Life life{.number = next_number_, .method = "added", .genome = genome, .born = tick_};
    life.uid = newcomer_uid();
    auto grown = Resident::grow(std::move(life), kinds_.creature, *settings_, senses_);
    if (!grown)
        return Error{fmt::format("The creature cannot live here: {}.", grown.error().message)};
    Resident& resident = **grown;
    if (!resident.can_move())
        return Error{
            "The creature cannot live here: none of its joints follows more than constants."};
    const std::optional<Vec3> center = room_near(place, resident);
    if (!center) return Error{kNoRoom};
    if (!area_.holds(*center, resident.radius()))
        return Error{"The creature is too large for the walls."};
    if (!can_pay(resident)) {
        return Error{fmt::format("The light has {} left, and the creature costs {}.",
                                 joules_text(ambient_), joules_text(price_of(resident)))};
    }
    resident.place(*center, Vec3::Zero());
    const std::uint64_t number = next_number_;
    settle(*std::move(grown));
    feel_energy();
    return number;
}

}  // namespace cambrian
