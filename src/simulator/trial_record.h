#pragma once

// What is kept of one trial: sampled motion, the highest jump, the audit, a digest.

#include "math/bounds.h"
#include "simulator/jump_watch.h"
#include "simulator/outcome.h"
#include "world/physics_scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace cambrian {

struct MotionSample {
    double time = 0.0;  // s since the test began
    Vec3 center_of_mass = Vec3::Zero();
    Bounds bounds;  // of all corners
};

struct TrialRecord {
    Outcome outcome = Outcome::kCompleted;
    std::string reason;               // of any outcome but completed, for a person
    double duration = 0.0;            // s, of the test phase as asked for
    double settle_time = 0.0;         // s
    double computed_time = 0.0;       // s, of the test phase; less than asked for if stopped early
    double body_length = 0.0;         // m, simulator/README.md 1
    double mass = 0.0;                // kg
    double reversal_rate = 0.0;       // Hz, of the busiest joint; swings over 0.05 rad
    double mean_reversal_rate = 0.0;  // Hz, of all joints that can move
    std::vector<MotionSample> samples;  // every 0.1 s from 0 to duration, unless failed
    JumpWatch jumps;                    // of every tick of the test phase
    SceneAudit audit;                   // of the test phase
    std::uint64_t digest = 0;           // of the state at every sample and the start of settling
};

}  // namespace cambrian
