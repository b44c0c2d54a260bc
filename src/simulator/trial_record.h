#pragma once

// The record of a trial: sampled motion, the highest jump, the energy audit, a digest.

#include "math/bounds.h"
#include "math/types.h"
#include "simulator/contest/bout_distances.h"
#include "simulator/jump_watch.h"
#include "simulator/supports.h"
#include "world/physics_scene.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// The end of a creature's evaluation.
enum class Outcome : std::uint8_t {
    kCompleted,
    kStoppedEarly,  // terminated because the rest could not matter
    kRejected,      // not simulated: no movable joint, or no connected control
    kDiverged,      // physics found no finite motion
    kDisqualified,  // a limit of the trial was exceeded (simulator/README.md 2)
    kOverBudget,    // computing the motion would take too long
    kInterrupted,   // stopped from outside; not caused by the creature
};

// Returns how far a creature came, from 0 for a completed trial to 3 for a motion that is invalid.
// Scores compare only creatures that came equally far; whoever came less far ranks below.
int shortfall(Outcome outcome);

// Returns whether the creature itself is the reason why there is no valid motion.
bool is_invalid(Outcome outcome);

std::string_view outcome_name(Outcome outcome);  // "completed", "stopped-early"...

// Distances of a creature to the light, for each leg of a trial. A leg lasts from one jump of
// the light to the next. Distances are from the centre of mass to the light, in m.

struct LightLeg {
    double time = 0.0;              // s, of the start
    Vec3 direction = Vec3::Zero();  // to the light at the start; a unit vector, or 0
    double start = 0.0;
    double unit = 0.0;     // body length at the start, m, the unit of the way that was set
    double end = 0.0;      // so far
    double nearest = 0.0;  // so far
    double mean = 0.0;     // over the ticks so far
    int ticks = 0;
};

class LightLegs {
public:
    // Reserves memory for the legs of a trial.
    void reserve(std::size_t legs);
    // Records the way to the light at the start of a leg (s), before its first tick, and the body's
    // length so far.
    void begin(double time, const Vec3& way, double length);
    // Records the distance after a tick.
    void watch(double distance);
    // Adds legs with the last distance, from the end of a trial on, until there are this many.
    void rest(std::size_t legs, double end);

    const std::vector<LightLeg>& all() const { return legs_; }

private:
    std::vector<LightLeg> legs_;
};

struct MotionSample {
    double time = 0.0;  // s since the test began
    Vec3 center_of_mass = Vec3::Zero();
    Bounds bounds;  // of all corners
    // Height of the ground at the left and the right end of the bounds, in m, as the mean over a
    // metre; 0 where it is flat.
    double ground_low = 0.0, ground_high = 0.0;
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
    int dimensions = 2;  // of the world
    // Against gravity, as the settings have it; away from the ground without gravity. Its x says
    // which way a slope rises.
    Vec3 up = Vec3::UnitY();
    double level_ground = 0.0;  // m, from the start to either side, of ground with a shape
    int wall_side = 0;          // of the wall: 1 to the right, -1 to the left, 0 for none
    double passive_sink = 0.0;  // m/s, of the environment (simulator/passive_sink.h)
    // Hz, of the joint with the highest rate; swings over 0.05 rad count.
    double reversal_rate = 0.0;
    double mean_reversal_rate = 0.0;    // Hz, of all joints that can move
    std::vector<MotionSample> samples;  // every 0.1 s from 0 to duration, unless failed
    std::vector<Supports> supports;     // of the same moments; in space only
    JumpWatch jumps;                    // of every tick of the test phase
    LightLegs legs;                     // of the same; none without a light
    std::optional<BoutDistances> bout;  // at the end of a contest
    SceneAudit audit;                   // of the test phase
    std::uint64_t digest = 0;           // of the state at the start of settling and at every sample

    // Adds the last supports, moved by so much (m), for a sample that was not computed.
    void repeat_supports(const Vec3& moved = Vec3::Zero());
};

}  // namespace cambrian
