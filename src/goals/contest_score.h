#pragma once

#include "simulator/contest/bout_distances.h"

namespace cambrian {

// Returns the score of the creature that is judged, from 0 to 2. That of the opponent, with the
// distances exchanged, adds up with it to exactly 2.
inline double contest_score(const BoutDistances& end) {
    const double sum = end.own + end.other;
    return sum > 0.0 ? 1.0 + (end.other - end.own) / sum : 1.0;
}

}  // namespace cambrian
