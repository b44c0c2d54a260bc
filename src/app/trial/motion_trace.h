#pragma once

// The motion of one trial as a table (CSV): a row a tick of 1/60 s, from the beginning of the test
// to its end. Columns: time (s), centre of mass (m), then for every part its centre (m), its angle
// (rad) and its joint's coordinate (rad or m).

#include "core/files/output_stream.h"
#include "core/result.h"
#include "evolution/settings/experiment_settings.h"
#include "genome/genome.h"
#include "simulator/trial_watch.h"

namespace cambrian {

// Runs the first trial and writes it row by row. Fails if physics refuses the body, if the trial
// is asked to stop or if the output cannot be written.
Status write_motion_trace(OutputStream& output, const Genome& genome,
                          const ExperimentSettings& settings, const Kinds& kinds,
                          const TrialWatch& watch);

}  // namespace cambrian
