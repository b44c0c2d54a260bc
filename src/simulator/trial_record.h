#pragma once

// The record of a trial: sampled motion, the highest jump, the energy audit, a digest.

#include "math/bounds.h"
#include "simulator/contest/bout_distances.h"
#include "simulator/jump_watch.h"
#include "simulator/outcome.h"
#include "simulator/surroundings/light_legs.h"
#include "world/physics_scene.h"

#include <cstdint>
#include <optional>
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
    std::string reason;        // reason of any outcome but completed, in words
    double duration = 0.0;     // s, planned length of the test phase
    double settle_time = 0.0;  // s
    // Computed time of the test phase, in s; less than `duration` if it ended early.
    double computed_time = 0.0;
    double body_length = 0.0;  // m, simulator/README.md 1
    double mass = 0.0;         // kg
    bool has_ground = false;
    // Against gravity, as the settings have it; away from the ground without gravity. Its x says
    // which way a slope rises.
    Vec3 up = Vec3::UnitY();
    double passive_sink = 0.0;  // m/s, of the environment (simulator/passive_sink.h)
    // Hz, of the joint with the highest rate; swings over 0.05 rad count.
    double reversal_rate = 0.0;
    double mean_reversal_rate = 0.0;    // Hz, of all joints that can move
    std::vector<MotionSample> samples;  // every 0.1 s from 0 to duration, unless failed
    JumpWatch jumps;                    // of every tick of the test phase
    LightLegs legs;                     // of the same; none without a light
    std::optional<BoutDistances> bout;  // at the end of a contest
    SceneAudit audit;                   // of the test phase
    std::uint64_t digest = 0;           // of the state at the start of settling and at every sample
};

}  // namespace cambrian
