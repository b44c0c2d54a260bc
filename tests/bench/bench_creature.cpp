#include "bench/bench_creature.h"

#include "math/elementary.h"
#include "support/body_plans.h"

#include <cmath>

namespace cambrian::bench {
namespace {

constexpr double kMuscleStress = 20.0;     // N m of torque per metre of section
constexpr double kBranchShare = 1.0 / 3;   // share of parts attached to a side
constexpr double kGroundClearance = 0.02;  // m

PlannedPart random_rectangle(RandomStream& stream) {
    PlannedPart part;
    part.half_extents.x() = stream.uniform(0.10, 0.35);
    part.half_extents.y() = stream.uniform(0.03, 0.10);
    part.motion = kRotaryJoint;
    return part;
}

void attach_at_random(const BodyPlan& plan, PlannedPart& child, RandomStream& stream) {
    const std::size_t last = plan.parts.size() - 1;
    const double bend = stream.uniform(-0.5, 0.5);
    if (last > 0 && stream.chance(kBranchShare)) {
        const std::size_t parent = stream.below(plan.parts.size());
        const Vec3& half = plan.parts[parent].half_extents;
        const double side = stream.chance(0.5) ? 1.0 : -1.0;
        const Vec3 anchor(stream.uniform(-half.x(), half.x()), side * half.y(), 0.0);
        join(plan, child, static_cast<int>(parent), anchor, side * kPi / 2 + bend);
    } else {
        const Vec3 anchor(plan.parts[last].half_extents.x(), 0.0, 0.0);
        join(plan, child, static_cast<int>(last), anchor, bend);
    }
}

void lift_above_ground(BodyPlan& plan) {
    double lowest = 0.0;
    for (const PlannedPart& part : plan.parts) {
        const SineCosine turn = sine_cosine(part.rest_angle);
        const double reach = std::fabs(turn.sine) * part.half_extents.x() +
                             std::fabs(turn.cosine) * part.half_extents.y();
        lowest = std::fmin(lowest, part.rest_pose.position.y() - reach);
    }
    for (PlannedPart& part : plan.parts)
        part.rest_pose.position.y() += kGroundClearance - lowest;
}

// Makes a joint swing over its full range.
void add_swing(BenchCreature& creature, std::size_t part, RandomStream& stream) {
    const PlannedPart& moved = creature.plan.parts[part];
    const double frequency = stream.uniform(0.3, 2.0);  // Hz
    const double phase = stream.uniform(0.0, 2 * kPi);
    const double middle = 0.5 * (moved.limit_high + moved.limit_low);
    const double half_range = 0.5 * (moved.limit_high - moved.limit_low);
    const std::size_t parts = creature.plan.parts.size();
    for (std::size_t tick = 0; tick * parts < creature.targets.size(); ++tick) {
        const double time = static_cast<double>(tick) * kTestTick;
        creature.targets[tick * parts + part] =
            middle + half_range * sine(2 * kPi * frequency * time + phase);
    }
}

}  // namespace

BenchCreature random_creature(std::size_t bodies, std::uint64_t seed, std::size_t ticks) {
    RandomStream stream(stream_seed(seed, bodies, 0, Purpose::kTest));
    BenchCreature creature;
    BodyPlan& plan = creature.plan;
    plan.parts.push_back(random_rectangle(stream));
    while (plan.parts.size() < bodies) {
        PlannedPart child = random_rectangle(stream);
        attach_at_random(plan, child, stream);
        child.limit_low = stream.uniform(-1.2, -0.4);
        child.limit_high = stream.uniform(0.4, 1.2);
        const double parent_half =
            plan.parts[static_cast<std::size_t>(child.parent)].half_extents.y();
        child.max_effort = kMuscleStress * 2.0 * std::fmin(child.half_extents.y(), parent_half);
        plan.parts.push_back(child);
    }
    lift_above_ground(plan);
    creature.targets.assign(ticks * bodies, 0.0);
    for (std::size_t part = 1; part < bodies; ++part)
        add_swing(creature, part, stream);
    return creature;
}

BenchCreature passive_chain(std::size_t bodies, std::size_t ticks) {
    constexpr double half_length = 0.2;        // m
    constexpr double half_width = 0.03;        // m
    constexpr double free_range = 100.0;       // rad; limits that are never reached
    constexpr std::size_t twisted_ticks = 12;  // 0.2 s
    BenchCreature creature;
    creature.targets.assign(ticks * bodies, 0.0);
    for (std::size_t i = 0; i < bodies; ++i) {
        PlannedPart part;
        part.half_extents = Vec3(half_length, half_width, 0.0);
        part.motion = kRotaryJoint;
        part.motor_mode = MotorMode::kTorque;
        part.limit_low = -free_range;
        part.limit_high = free_range;
        // The chain is folded, since parts that overlap at rest never collide.
        if (i > 0)
            join(creature.plan, part, static_cast<int>(i) - 1, Vec3(half_length, 0.0, 0.0),
                 i % 2 == 1 ? kPi : -kPi);
        part.max_effort = i == 0 ? 0.0 : 0.01 + 0.002 * static_cast<double>(i * 5 % 7);  // N m
        creature.plan.parts.push_back(part);
        for (std::size_t tick = 0; tick < twisted_ticks; ++tick)
            creature.targets[tick * bodies + i] = i % 3 == 2 ? -1.0 : 1.0;
    }
    return creature;
}

}  // namespace cambrian::bench
