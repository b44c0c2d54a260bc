#include "bench/runs.h"

#include "math/angle.h"

#include <cmath>
#include <time.h>

namespace cambrian::bench {
namespace {

Vec2 point_in_world(const PartMotion& part, const Vec3& point) {
    const double cosine = std::cos(part.angle);
    const double sine = std::sin(part.angle);
    return {part.x + cosine * point.x() - sine * point.y(),
            part.y + sine * point.x() + cosine * point.y()};
}

double mass_of(const PlannedPart& part, double density) {
    return 4 * density * part.half_extents.x() * part.half_extents.y();
}

}  // namespace

[[gnu::noinline]] std::unique_ptr<BenchEngine> build_scene(const EngineKind& kind,
                                                           const BodyPlan& plan,
                                                           const Environment& environment,
                                                           WorkAudit audit) {
    return kind.make(plan, environment, audit);
}

[[gnu::noinline]] void advance_scene(BenchEngine& engine, const BenchCreature& creature,
                                     std::size_t first_tick, std::size_t last_tick) {
    for (std::size_t tick = first_tick; tick < last_tick; ++tick) {
        for (std::size_t part = 1; part < creature.plan.parts.size(); ++part)
            engine.set_target(part, creature.target(tick, part));
        engine.advance_tick();
    }
}

Accuracy watch_run(const EngineKind& kind, const BenchCreature& creature,
                   const Environment& environment, std::size_t ticks) {
    const auto engine = build_scene(kind, creature.plan, environment, WorkAudit::kOn);
    std::vector<PartMotion> parts;
    engine->read_motion(parts);
    const double energy_at_start = mechanical_energy(creature.plan, environment, parts);
    Accuracy accuracy;
    for (std::size_t tick = 0; tick < ticks; ++tick) {
        advance_scene(*engine, creature, tick, tick + 1);
        engine->read_motion(parts);
        accuracy.greatest_joint_gap =
            std::fmax(accuracy.greatest_joint_gap, widest_joint_gap(creature.plan, parts));
        accuracy.greatest_kinetic_energy =
            std::fmax(accuracy.greatest_kinetic_energy,
                      kinetic_energy(creature.plan, environment.density, parts));
    }
    const double energy = mechanical_energy(creature.plan, environment, parts);
    accuracy.energy_residual = energy - energy_at_start - engine->explained_work();
    return accuracy;
}

double kinetic_energy(const BodyPlan& plan, double density, const std::vector<PartMotion>& parts) {
    double energy = 0.0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const PartMotion& motion = parts[i];
        const double square_radius = plan.parts[i].half_extents.head<2>().squaredNorm() / 3;
        energy += 0.5 * mass_of(plan.parts[i], density) *
                  (motion.velocity_x * motion.velocity_x + motion.velocity_y * motion.velocity_y +
                   square_radius * motion.spin * motion.spin);
    }
    return energy;
}

double mechanical_energy(const BodyPlan& plan, const Environment& environment,
                         const std::vector<PartMotion>& parts) {
    const double direction = to_radians(environment.gravity_direction);
    double energy = kinetic_energy(plan, environment.density, parts);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const double depth = std::cos(direction) * parts[i].x + std::sin(direction) * parts[i].y;
        energy -= mass_of(plan.parts[i], environment.density) * environment.gravity * depth;
    }
    return energy;
}

double widest_joint_gap(const BodyPlan& plan, const std::vector<PartMotion>& parts) {
    double widest = 0.0;
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const PlannedPart& part = plan.parts[i];
        const auto parent = static_cast<std::size_t>(part.parent);
        const Vec2 gap = point_in_world(parts[parent], part.anchor_in_parent) -
                         point_in_world(parts[i], part.anchor_in_child);
        widest = std::fmax(widest, gap.norm());
    }
    return widest;
}

}  // namespace cambrian::bench
