#pragma once

// The state of a preserve in numbers, every 10 s of its time.

#include "preserve/life/offspring.h"
#include "preserve/world/energy.h"
#include "preserve/world/food.h"

#include <cstdint>

namespace cambrian {

inline constexpr std::uint64_t kTicksPerRow = 600;  // 10 s

// Counts what happened since the row before.
struct Tally {
    std::uint64_t births = 0;
    std::uint64_t restocked = 0;
    std::uint64_t stillborn = 0;
    std::uint64_t hunger = 0, eaten = 0, broken_physics = 0;  // deaths by cause
};

struct SeriesRow : Tally {
    std::uint64_t tick = 0;
    std::uint64_t population = 0;
    std::uint64_t lineages = 0;
    // J
    double light = 0.0, plants = 0.0, flesh = 0.0, stores = 0.0, bodies = 0.0;
    // Means and standard deviations over the living; 0 if there are none.
    double mass = 0.0, mass_spread = 0.0;  // kg
    double parts = 0.0, parts_spread = 0.0;
    double speed = 0.0, speed_spread = 0.0;  // m/s, of centres of mass
    double diet = 0.0, diet_spread = 0.0;
    double age = 0.0;  // s
};

SeriesRow series_row(std::uint64_t tick, const Residents& residents, Energy ambient,
                     const Food& plants, const Food& flesh, const Tally& tally);

}  // namespace cambrian
