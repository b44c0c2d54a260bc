#pragma once

// The cube and the opponent of a displayed contest between two ticks.

#include "simulator/contest/bout.h"
#include "studio/playback/shown_motion.h"

namespace cambrian {

class ShownBout {
public:
    // Do the same as the functions of ShownMotion; null for trials without a contest.
    void follow(const Bout* bout) {
        if (bout == nullptr) return;
        cube_.follow(bout->cube());
        if (bout->opponent() != nullptr) opponent_.follow(*bout->opponent());
    }
    void jump_to(const Bout* bout) {
        if (bout == nullptr) return;
        cube_.jump_to(bout->cube());
        if (bout->opponent() != nullptr) opponent_.jump_to(*bout->opponent());
    }
    void show(double share) {
        cube_.show(share);
        opponent_.show(share);
    }

    const ShownMotion& cube() const { return cube_; }
    const ShownMotion& opponent() const { return opponent_; }

private:
    ShownMotion cube_;
    ShownMotion opponent_;
};

}  // namespace cambrian
