#pragma once

// A worker whose arithmetic is wrong now and then.

#include "cluster/messages/work_queue.h"

namespace cambrian::test {

// Flips the lowest bit of the fitness of one result in 50, the first one among them. That one is
// checked for certain; of later ones some would pass (trust.h).
class BitFlipper {
public:
    // Whether one of the unit's results was changed.
    bool change(UnitMessage& unit);

private:
    int results_ = 0;
};

}  // namespace cambrian::test
