#include "goals/sampling.h"

#include "core/assert.h"

#include <algorithm>
#include <cmath>

namespace cambrian {

const MotionSample& sample_at(const TrialRecord& record, double share) {
    CAMBRIAN_ASSERT(!record.samples.empty(), "a completed record has samples");
    const double last = static_cast<double>(record.samples.size() - 1);
    const double index = std::clamp(std::nearbyint(share * last), 0.0, last);
    return record.samples[static_cast<std::size_t>(index)];
}

}  // namespace cambrian
