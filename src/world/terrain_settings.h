#pragma once

// What decides the shape of the ground, as plain data. Lengths are in m.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace cambrian {

// The first is the half-plane y <= 0.
inline constexpr std::array<std::string_view, 10> kTerrainIds = {
    "flat", "slope", "rough", "hills", "stairs", "blocks", "gaps", "hurdles", "course", "drawn"};
inline constexpr std::array<std::string_view, 2> kTerrainSideIds = {"mirrored", "different"};

inline constexpr double kLeastTerrainLevel = 0.05;
inline constexpr std::size_t kMostGroundPoints = 2000;  // of drawn ground

struct TerrainSettings {
    std::string kind = "flat";  // one of kTerrainIds
    double height = 0.15;       // 0 to 2; of bumps, steps, blocks or hurdles
    double spacing = 0.6;       // 0.2 to 10; between two of them
    double gap = 0.4;           // 0.1 to 5; width of the widest gap
    double slope = 0.0;         // degrees, 0 to 45; the ground rises away from the start
    double pad = 1.5;           // 1 to 20; the ground is level so far to both sides of the start
    // "mirrored": both sides are alike. "different": each has its own shape.
    std::string sides = "mirrored";
    std::uint64_t seed = 1;  // of the shapes that are drawn by chance
    // Whether all trials have the same ground. Otherwise it follows from the chance of the trial.
    bool same = true;
    // Share of height, gap and slope that is in force, 0.05 to 1.
    double level = 1.0;
    bool ladder = false;      // evolution raises the level (evolution/README.md 8)
    std::string points = {};  // of drawn ground: "x y; x y; ..."
    // m; the ground repeats after so far, as round a world whose edges meet. 0: it goes on without
    // an end. No file names it.
    double world_width = 0.0;

    bool is_flat() const { return kind == "flat"; }

    friend bool operator==(const TerrainSettings&, const TerrainSettings&) = default;
};

}  // namespace cambrian
