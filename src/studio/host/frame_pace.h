#pragma once

// Chooses how much of the scenery is drawn, by the time that drawing takes.

#include "studio/look/view_state.h"

#include <array>
#include <cstddef>

namespace cambrian {

class FramePace {
public:
    // Tells of a frame: the time in which it was drawn and the time since the one before, in s.
    // When most of the last 30 frames took over 15 ms for a second, scenery is light, and plain
    // when they take over 30 ms even so. When they took less than 7 ms for ten seconds, the tier is
    // one higher, at most twice.
    void note(double drawing, double elapsed);
    Scenery tier() const { return tier_; }  // never kAutomatic

private:
    static constexpr std::size_t kFrames = 30;

    void choose(Scenery tier);

    std::array<double, kFrames> drawing_ = {};  // s
    std::size_t noted_ = 0;                     // frames since the tier was chosen
    double slow_ = 0.0;                         // s for which frames are too slow
    double quick_ = 0.0;                        // s for which they leave much room
    int raised_ = 0;
    Scenery tier_ = Scenery::kFull;
};

}  // namespace cambrian
