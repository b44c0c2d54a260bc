#pragma once

// The search for room for a creature. Solid creatures leave none to each other, and
// walls none to anybody.

#include "evolution/settings/world_area.h"
#include "preserve/life/offspring.h"
#include "preserve/world/drawn_walls.h"

#include <cstddef>
#include <optional>
#include <span>

namespace cambrian {

inline constexpr int kBirthPlaces = 16;  // around a parent

// Returns the direction, as a unit vector, of a place on a spiral whose places are spread evenly.
Vec3 spiral_direction(double index);

// One of the places around a parent, of which a turn drawn by chance is the first.
struct BirthTurn {
    std::size_t first = 0, index = 0;
};

// A view of a world at one moment; what it refers to must outlive it.
class Room {
public:
    Room(const WorldArea& area, const DrawnWalls& walls, const Residents& residents, bool is_solid)
        : area_(area), walls_(walls), residents_(residents), is_solid_(is_solid) {}

    // Returns the place or, if there is ground, that of the resident standing below it.
    Vec3 footing(const Vec3& place, const Resident& resident) const;
    // Returns whether there is room for a resident with these bounds.
    bool is_free(const Bounds& bounds, const Resident& of) const;
    // Returns the first free place, between the walls, from the one asked for outwards, that does
    // not overlap what is taken besides if creatures are solid.
    std::optional<Vec3> nearest(const Vec3& asked, const Resident& resident,
                                std::span<const Bounds> taken = {}) const;
    // Returns a place on a circle around the parent or, on ground, beside it: to both sides in
    // turn, farther and farther away. It need not be free.
    Vec3 birth_place(const Resident& parent, const Resident& child, const BirthTurn& turn) const;

private:
    const WorldArea& area_;
    const DrawnWalls& walls_;
    const Residents& residents_;
    bool is_solid_;
};

}  // namespace cambrian
