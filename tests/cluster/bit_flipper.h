#pragma once

// A worker whose arithmetic is occasionally wrong.

#include "cluster/messages/work_queue.h"

#include <optional>

namespace cambrian::test {

// Flips the lowest bit of the fitness of the first result of each batch. The first of them that
// comes in time is the first result of this worker that counts, so its check is certain (trust.h);
// of false results that come later some would pass.
class BitFlipper {
public:
    // Returns whether a result of the unit was changed.
    bool change(UnitMessage& unit);

private:
    std::optional<UnitId> last_;  // the unit that was changed last
};

}  // namespace cambrian::test
