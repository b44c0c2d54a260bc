#include "dynamics/stepping/part_forces.h"

namespace cambrian {
namespace {

// m/s, of the centre of a part.
Vec2 center_velocity(const PlanarModel& model, const Kinematics& k, int part) {
    const int b = model.part_body[part];
    const double arm_x = k.cosine[b] * model.part_x[part] - k.sine[b] * model.part_y[part];
    const double arm_y = k.sine[b] * model.part_x[part] + k.cosine[b] * model.part_y[part];
    return {k.velocity_x[b] - k.spin[b] * arm_y, k.velocity_y[b] + k.spin[b] * arm_x};
}

}  // namespace

void begin_forces(const PlanarModel& model, const Kinematics& kinematics, PartForces& forces) {
    for (int part = 0; part < model.part_count; ++part) {
        const Vec2 velocity = center_velocity(model, kinematics, part);
        forces.specific_x[part] = velocity.x();
        forces.specific_y[part] = velocity.y();
        forces.load[part] = 0.0;
    }
}

void add_load(const Contact& contact, double impulse, PartForces& forces) {
    forces.load[contact.part_a] += impulse;
    if (contact.part_b >= 0) forces.load[contact.part_b] += impulse;
}

void end_forces(const PlanarModel& model, const Medium& medium, const Kinematics& kinematics,
                double duration, PartForces& forces) {
    for (int part = 0; part < model.part_count; ++part) {
        const Vec2 velocity = center_velocity(model, kinematics, part);
        forces.specific_x[part] =
            (velocity.x() - forces.specific_x[part]) / duration - medium.gravity_x;
        forces.specific_y[part] =
            (velocity.y() - forces.specific_y[part]) / duration - medium.gravity_y;
        forces.load[part] /= duration;
    }
}

}  // namespace cambrian
