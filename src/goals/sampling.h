#pragma once

#include "simulator/trial_record.h"

namespace cambrian {

// Returns the sample nearest to a share (0 to 1) of the test phase; the record must have samples.
const MotionSample& sample_at(const TrialRecord& record, double share);

}  // namespace cambrian
