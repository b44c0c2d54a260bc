#pragma once

// Food of one kind that lies about, found by its place.

#include "evolution/settings/world_area.h"
#include "preserve/world/energy.h"
#include "preserve/world/rectangle.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cambrian {

struct Pellet {
    double x = 0.0, y = 0.0;  // m, between the walls
    Energy energy = 0;        // above 0

    Vec3 place() const { return {x, y, 0.0}; }
};

class Food {
public:
    // With ground, pellets lie at most so high above it (m).
    explicit Food(const WorldArea& area, double limit = 0.0);

    // Adds a pellet, unless it has no energy. Its place is moved between the walls or, where edges
    // meet, to its image in the area, and above the ground.
    void add(const Vec3& place, Energy energy);
    // Adds energy to a pellet within a distance (m), or as a new one.
    void add_near(const Vec3& place, Energy energy, double distance);
    // Removes the pellets within a distance (m) of a rectangle or its images and returns them, in
    // order of their indices. The result is valid until the next call.
    std::span<const Pellet> take(const Rectangle& rectangle, double distance);
    // Takes a share in [0, 1] of each pellet's energy, at least one unit. A pellet that has less
    // than 1e-6 J left is removed with its rest. Returns the energy taken.
    Energy rot(double share);

    // Removes pellets, the last ones first, until they make up an energy or none is left.
    // Returns their energy.
    Energy take_at_least(Energy energy);

    Energy energy() const { return energy_; }  // of all
    std::span<const Pellet> all() const { return pellets_; }
    // Replaces all pellets, which keep their order.
    void replace(std::span<const Pellet> pellets);

private:
    Vec3 resting(const Vec3& place) const;
    int column(double x) const;
    int row(double y) const;
    std::vector<std::uint32_t>& cell_of(const Pellet& pellet);
    void remove(std::uint32_t index);
    template <class Visit>
    void visit(const Bounds& bounds, Visit visit);

    WorldArea area_;
    double limit_;
    int columns_, rows_;
    std::vector<Pellet> pellets_;
    std::vector<std::vector<std::uint32_t>> cells_;  // indices of pellets
    std::vector<std::uint32_t> found_;
    std::vector<Pellet> taken_;
    Energy energy_ = 0;
};

}  // namespace cambrian
