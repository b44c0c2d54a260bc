#pragma once

// The motion of one trial as a CSV table with one row per tick of 1/60 s of the test. The columns
// are the time (s), the centre of mass (m), and for every part its centre (m), its angle (rad) and
// its joint coordinate (rad or m); then, where there are any, the signals of organs, the stretches
// of parts, the sum of all scent, and the place of the light (m).

#include "core/files/output_stream.h"
#include "core/result.h"
#include "evolution/evaluation/trials.h"
#include "simulator/trial_watch.h"

namespace cambrian {

// Runs a trial and writes it row by row. Fails if physics rejects the body, if a stop is
// requested or if the output cannot be written.
Status write_motion_trace(OutputStream& output, const TrialSetup& setup,
                          const ExpressionSettings& expression, const Kinds& kinds,
                          const TrialWatch& watch);

}  // namespace cambrian
