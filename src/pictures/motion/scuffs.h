#pragma once

// Where a moving body stirs up its world: feet that slip on the ground and tips that are swift in a
// fluid. Pictures show dust, bubbles and eddies there. All of it follows from the motion.

#include "pictures/motion/touched_faces.h"
#include "world/body_plan.h"

#include <cstdint>
#include <span>
#include <vector>

namespace cambrian {

struct Scuff {
    double time = 0.0;             // s since the test began
    Vec2 place = Vec2::Zero();     // m
    Vec2 velocity = Vec2::Zero();  // m/s, of the body there
    std::uint64_t seed = 0;        // different for each tick and part
};

inline constexpr double kScuffLife = 0.7;  // s for which a scuff is seen

// A body at one tick; each span has one entry for each part.
struct BodyMoment {
    std::span<const Pose> poses;
    std::span<const double> stretches;
    std::span<const FaceSet> touched;
};

// Adds the scuffs of the tick between two moments. `tick` counts from the start of the test. On
// ground only touching parts make them, in a fluid only parts but the root.
void add_scuffs(std::vector<Scuff>& scuffs, const BodyPlan& plan, std::uint64_t tick,
                const BodyMoment& before, const BodyMoment& after, bool walks);

// Returns those that are seen at a time. They must be in ascending order of times.
std::span<const Scuff> scuffs_seen(std::span<const Scuff> scuffs, double time);

}  // namespace cambrian
