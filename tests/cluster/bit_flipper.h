#pragma once

// A worker whose arithmetic is occasionally wrong.

#include "cluster/messages/work_queue.h"

namespace cambrian::test {

// Flips the lowest bit of the fitness of one result in 50, including the first one. The first one
// is always checked; later ones might pass unchecked (trust.h).
class BitFlipper {
public:
    // Returns whether a result of the unit was changed.
    bool change(UnitMessage& unit);

private:
    int results_ = 0;
};

}  // namespace cambrian::test
