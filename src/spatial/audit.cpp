#include "spatial/audit.h"

#include "dynamics/step_policy.h"

#include <algorithm>
#include <cmath>

namespace cambrian::spatial {

Vec3 part_velocity(const Model& model, const State& state, int index) {
    const Part& part = model.parts[index];
    const Kinematics& k = state.evaluation->kinematics;
    return k.velocity[part.body] + cross(k.spin[part.body], k.turn[part.body] * part.place) +
           coordinate_vector(state.motion.speed + model.place());
}

void note_speeds(const Model& model, State& state) {
    SceneAudit& audit = state.audit;
    for (int p = 0; p < model.part_count; ++p) {
        const Vec3 velocity = part_velocity(model, state, p);
        audit.max_part_speed = std::max(audit.max_part_speed, std::sqrt(dot(velocity, velocity)));
    }
    for (int b = 0; b < model.body_count; ++b) {
        const Vec3& spin = state.evaluation->kinematics.spin[b];
        audit.max_part_spin = std::max(audit.max_part_spin, std::sqrt(dot(spin, spin)));
    }
}

void update_audit(const Model& model, const Medium& medium, State& state) {
    const double* work = state.motion.work;
    const double energy =
        mechanical_energy(model, medium, state.motion, state.evaluation->kinematics);
    const double gravity = std::sqrt(dot(medium.gravity, medium.gravity));
    step_policy::note_works(
        {work[kMotorWork], work[kGrossMotorWork], work[kDragWork], work[kPullWork]},
        energy - state.energy_reference, model.mass * gravity, state.audit);
}

void start_audit(const Model& model, const Medium& medium, State& state) {
    for (double& work : state.motion.work)
        work = 0.0;
    state.audit = {};
    state.energy_reference =
        mechanical_energy(model, medium, state.motion, state.evaluation->kinematics);
    update_audit(model, medium, state);
}

}  // namespace cambrian::spatial
