#pragma once

// Touching boxes of one creature (physics.md 7.1).

#include "dynamics/contact/contact.h"
#include "dynamics/model/part_places.h"

namespace cambrian {

// Which of the model's pairs are near enough to be tested; rebuilt when the boxes have moved too
// far. What it finds does not depend on when that was.
class PairList {
public:
    // Adds at most two contacts a pair, everything nearer than kContactMargin.
    void collect(const PlanarModel& model, const Kinematics& kinematics, const PartPlaces& places,
                 ContactSet& contacts);

private:
    bool has_expired(const PlanarModel& model, const PartPlaces& places) const;
    void rebuild(const PlanarModel& model, const PartPlaces& places);

    struct NearPair {
        int index;             // of the model's pairs
        int first, second;     // parts
        double reach_squared;  // m^2, between the centres
    };
    static constexpr int kMaxPairs = kMaxParts * (kMaxParts - 1) / 2;
    bool built_ = false;
    int count_ = 0;
    NearPair pairs_[kMaxPairs];
    PerPart built_x_, built_y_;  // m, relative to part 0
};

}  // namespace cambrian
