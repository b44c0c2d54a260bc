#pragma once

// The record of one life.

#include "genome/genome.h"
#include "preserve/world/energy.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace cambrian {

enum class DeathCause : std::uint8_t { kAlive, kHunger, kEaten, kBrokenPhysics, kRemoved };
inline constexpr std::array<std::string_view, 5> kDeathCauses = {"", "hunger", "eaten",
                                                                 "broken physics", "removed"};

struct Life {
    std::uint64_t number = 0;  // counted from 1, in the order of births
    std::uint64_t uid = 0;
    std::array<std::uint64_t, 2> parents = {0, 0};  // numbers; 0 for none
    std::uint64_t lineage = 0;                      // number of its founder
    std::string method = {};  // breeding method, "founder", "restock" or "added"
    std::uint32_t mutations = 0;
    GenomePtr genome = {};
    std::uint64_t born = 0;  // tick
    std::uint64_t died = 0;  // tick; 0 while it lives
    DeathCause cause = DeathCause::kAlive;
    double x = 0.0, y = 0.0;  // m; place of its birth and, later, of its death
    double mass = 0.0;        // kg
    std::uint32_t parts = 0;
    std::uint32_t neurons = 0;  // connected
    double diet = 0.0;          // mean of its mouths
    Energy eaten_plants = 0;    // gained
    Energy eaten_flesh = 0;
    Energy bitten = 0;  // gained by bites
    Energy lost = 0;    // to bites
    std::uint32_t children = 0;
};

}  // namespace cambrian
