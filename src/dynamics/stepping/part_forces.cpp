#include "dynamics/stepping/part_forces.h"

#include <bit>

namespace cambrian {
namespace {

// Returns the velocity of a part's centre, in m/s.
Vec2 center_velocity(const PlanarModel& model, const Kinematics& k, int part) {
    const int b = model.part_body[part];
    const double arm_x = k.cosine[b] * model.part_x[part] - k.sine[b] * model.part_y[part];
    const double arm_y = k.sine[b] * model.part_x[part] + k.cosine[b] * model.part_y[part];
    return {k.velocity_x[b] - k.spin[b] * arm_y, k.velocity_y[b] + k.spin[b] * arm_x};
}

bool is_measured(const PlanarModel& model, int part) {
    return part >= 0 && ((model.measured_parts >> static_cast<unsigned>(part)) & 1U) != 0;
}

template <class Visit>
void each_measured(const PlanarModel& model, const Visit& visit) {
    for (std::uint64_t left = model.measured_parts; left != 0; left &= left - 1)
        visit(std::countr_zero(left));
}

}  // namespace

void note_speeds(const PlanarModel& model, const Kinematics& kinematics, PartForces& forces) {
    each_measured(model, [&](int part) {
        const Vec2 velocity = center_velocity(model, kinematics, part);
        forces.speed_x[part] = velocity.x();
        forces.speed_y[part] = velocity.y();
    });
}

void begin_forces(const PlanarModel& model, PartForces& forces) {
    each_measured(model, [&](int part) { forces.load[part] = 0.0; });
}

void add_load(const PlanarModel& model, const Contact& contact, double impulse,
              PartForces& forces) {
    if (is_measured(model, contact.part_a)) forces.load[contact.part_a] += impulse;
    if (is_measured(model, contact.part_b)) forces.load[contact.part_b] += impulse;
}

void end_forces(const PlanarModel& model, const Medium& medium, const Kinematics& kinematics,
                double duration, PartForces& forces) {
    each_measured(model, [&](int part) {
        const Vec2 velocity = center_velocity(model, kinematics, part);
        forces.specific_x[part] =
            (velocity.x() - forces.speed_x[part]) / duration - medium.gravity_x;
        forces.specific_y[part] =
            (velocity.y() - forces.speed_y[part]) / duration - medium.gravity_y;
        forces.speed_x[part] = velocity.x();
        forces.speed_y[part] = velocity.y();
        forces.load[part] /= duration;
    });
}

}  // namespace cambrian
