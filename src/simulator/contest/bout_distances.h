#pragma once

namespace cambrian {

// The distances at the end of a contest, in m: the shortest from any point of a creature to the
// centre of the cube.
struct BoutDistances {
    double own = 0.0;    // of the creature that is judged
    double other = 0.0;  // of its opponent

    friend bool operator==(const BoutDistances&, const BoutDistances&) = default;
};

}  // namespace cambrian
