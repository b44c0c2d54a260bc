#pragma once

// The sounds of one tick and their loudness anywhere (simulator/README.md 6), for any number of
// creatures.

#include "math/torus.h"
#include "world/emissions.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cambrian {

// Returns the loudness that is left of a sound at a distance, in m.
inline double loudness_at(double distance, double loudness) {
    return loudness / (1.0 + distance);
}

class LoudnessSum {
public:
    // Sounds come from their nearest images on the torus.
    explicit LoudnessSum(const Torus& torus = {}) : torus_(torus) {}

    // Allocates nothing later if at most this many sounds are added between two clear()s.
    void reserve(std::size_t sounds);
    void clear();
    // Adds a sound of a creature. Sounds too faint to be heard are left out.
    void add(const Sound& sound, std::uint32_t creature);
    // Must be called after the last add() and before at().
    void finish();

    // Returns the loudness of a band at a point for a creature, without its own sounds. Sounds
    // within the cell of the point and the eight around it are summed exactly; those of any farther
    // cell count as one sound at their centre, with an error of at most 3 % beyond 6 m. The sum has
    // the same bits whatever the order of creatures, if each adds its own sounds in the same order.
    double at(const Vec3& point, int band, std::uint32_t creature) const;

private:
    struct Heard {
        Sound sound;
        std::uint32_t creature = 0;
        std::uint32_t number = 0;  // order of addition
        int cell_x = 0, cell_y = 0;
    };
    // The sounds of one band in one square of 4 m: a range of sounds_.
    struct Cell {
        int band = 0;
        int x = 0, y = 0;
        std::size_t begin = 0, end = 0;
        double loudness = 0.0;       // sum
        Vec3 center = Vec3::Zero();  // mean of the places, weighted by loudness
    };

    bool is_near_across(const Cell& cell, const Vec3& point) const;
    bool is_of(const Cell& cell, std::uint32_t creature) const;
    double exact(const Cell& cell, const Vec3& point, std::uint32_t creature) const;

    Torus torus_;
    std::vector<Heard> sounds_;
    std::vector<Cell> cells_;
};

}  // namespace cambrian
