#pragma once

// The sounds and scents of one tick, for others to hear and smell (simulator/README.md 6).

#include "math/types.h"

#include <vector>

namespace cambrian {

inline constexpr int kSoundBands = 4;

// A sound that lasts one tick.
struct Sound {
    Vec3 place = Vec3::Zero();  // m
    int band = 0;               // below kSoundBands
    double loudness = 0.0;      // 0 to 1, at no distance
};

struct Scent {
    Vec3 place = Vec3::Zero();  // m
    double amount = 0.0;        // of the tick; a full organ gives off 1 a second
};

struct Emissions {
    std::vector<Sound> sounds;
    std::vector<Scent> scents;

    void clear() {
        sounds.clear();
        scents.clear();
    }
};

}  // namespace cambrian
