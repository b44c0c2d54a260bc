#include "preserve/life/room.h"

#include "math/elementary.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

// Returns the place nearest to the one asked for at which a circle is between the walls; where
// edges meet, its image in the area.
Vec3 place_between_walls(const WorldArea& area, const Vec3& asked, double radius) {
    const double x = std::max(0.5 * area.width - radius, 0.0);
    const double y = std::max(0.5 * area.height - radius, 0.0);
    const Vec3 middle = area.middle();
    Vec3 place = area.torus().shortest(asked);
    if (area.has_sides()) place.x() = std::clamp(place.x(), -x, x);
    if (area.has_top()) place.y() = std::clamp(place.y(), middle.y() - y, middle.y() + y);
    return place;
}

// Returns how far the next place to look for room is from the first one, for a circle: on a spiral
// or, on ground, to both sides in turn.
Vec3 next_place(const WorldArea& area, double radius, int index) {
    if (area.has_ground) {
        const double side = index % 2 == 0 ? 0.25 : -0.25;
        return {side * radius * (index + index % 2), 0.0, 0.0};
    }
    const auto place = static_cast<double>(index);
    return radius * std::sqrt(place) * spiral_direction(place);
}

}  // namespace

Vec3 spiral_direction(double index) {
    constexpr double kGoldenTurn = 2.399963230;  // rad
    const SineCosine turn = sine_cosine(kGoldenTurn * index);
    return {turn.cosine, turn.sine, 0.0};
}

Vec3 Room::footing(const Vec3& place, const Resident& resident) const {
    return area_.has_ground ? resident.standing_at(place.x(), area_) : place;
}

bool Room::is_free(const Bounds& bounds, const Resident& of) const {
    if (walls_.meet(bounds)) return false;
    return !is_solid_ || std::none_of(residents_.begin(), residents_.end(), [&](const auto& each) {
        return each.get() != &of && overlap(each->bounds(), bounds, area_.torus());
    });
}

std::optional<Vec3> Room::nearest(const Vec3& asked, const Resident& resident,
                                  std::span<const Bounds> taken) const {
    constexpr int kPlaces = 64;
    for (int i = 0; i < kPlaces; ++i) {
        const Vec3 place =
            footing(place_between_walls(area_, asked + next_place(area_, resident.radius(), i),
                                        resident.radius()),
                    resident);
        const Vec3 shift = place - resident.center();
        const Bounds bounds = moved(resident.bounds(), shift);
        const bool is_taken =
            is_solid_ && std::any_of(taken.begin(), taken.end(), [&](const Bounds& other) {
                return overlap(other, bounds, area_.torus());
            });
        if (!is_taken && is_free(bounds, resident)) return place;
    }
    return std::nullopt;
}

Vec3 Room::birth_place(const Resident& parent, const Resident& child, const BirthTurn& turn) const {
    const std::size_t which = (turn.first + turn.index) % kBirthPlaces;
    if (!area_.has_ground) {
        const double distance = parent.radius() + child.radius();
        const double share = static_cast<double>(which) / kBirthPlaces;
        const SineCosine direction = sine_cosine(2.0 * kPi * share);
        return parent.center() + distance * Vec3(direction.cosine, direction.sine, 0.0);
    }
    const Bounds& own = child.bounds();
    const std::size_t steps = turn.index / 2;
    const double away =
        kStartClearance + 0.5 * static_cast<double>(steps) * (own.high.x() - own.low.x());
    const double x = which % 2 == 0
                         ? parent.bounds().high.x() + away + child.center().x() - own.low.x()
                         : parent.bounds().low.x() - away + child.center().x() - own.high.x();
    return child.standing_at(x, area_);
}

}  // namespace cambrian
