#include "dynamics/audit.h"

#include <cmath>

namespace cambrian {

double mechanical_energy(const PlanarModel& model, const Medium& medium, const Motion& motion,
                         const Kinematics& kinematics) {
    return kinetic_energy(model, kinematics) -
           model.total_mass *
               (medium.gravity_x * motion.position[0] + medium.gravity_y * motion.position[1]);
}

void note_speeds(const PlanarModel& model, const Kinematics& k, SceneAudit& audit) {
    double fastest = 0.0;
    for (int part = 0; part < model.part_count; ++part) {
        const int b = model.part_body[part];
        const double arm_x = k.cosine[b] * model.part_x[part] - k.sine[b] * model.part_y[part];
        const double arm_y = k.sine[b] * model.part_x[part] + k.cosine[b] * model.part_y[part];
        const double x = k.velocity_x[b] - k.spin[b] * arm_y;
        const double y = k.velocity_y[b] + k.spin[b] * arm_x;
        fastest = std::fmax(fastest, x * x + y * y);
    }
    audit.max_part_speed = std::fmax(audit.max_part_speed, std::sqrt(fastest));
    for (int b = 0; b < model.body_count; ++b)
        audit.max_part_spin = std::fmax(audit.max_part_spin, std::fabs(k.spin[b]));
}

void note_depths(const PlanarModel& model, const Motion& motion, const Kinematics& kinematics,
                 const ContactSet& contacts, SceneAudit& audit) {
    for (int c = 0; c < contacts.count; ++c)
        audit.max_penetration = std::fmax(audit.max_penetration, -contacts.items[c].gap);
    for (int i = 1; i < model.body_count; ++i) {
        const double angle = joint_coordinate(model, motion, kinematics, i);
        const double overrun = std::fmax(model.limit_low[i] - angle, angle - model.limit_high[i]);
        audit.max_limit_overrun = std::fmax(audit.max_limit_overrun, overrun);
    }
}

void close_books(const PlanarModel& model, const Medium& medium, SceneMoment& moment) {
    SceneAudit& audit = moment.audit;
    const double* work = moment.motion.work;
    audit.motor_work = work[kMotorWork];
    audit.gross_motor_work = work[kGrossMotorWork];
    audit.drag_work = work[kDragWork];
    const double explained = work[kMotorWork] + work[kDragWork] + work[kPullWork] +
                             audit.contact_work + audit.limit_work + audit.impulse_work;
    const double energy = mechanical_energy(model, medium, moment.motion, moment.frame.kinematics);
    audit.energy_residual = energy - moment.energy_reference - explained;
    const double gravity =
        std::sqrt(medium.gravity_x * medium.gravity_x + medium.gravity_y * medium.gravity_y);
    constexpr double kScaleHeight = 0.01;  // m
    audit.energy_scale = audit.gross_motor_work + model.total_mass * gravity * kScaleHeight;
}

void open_books(const PlanarModel& model, const Medium& medium, SceneMoment& moment) {
    for (double& work : moment.motion.work)
        work = 0.0;
    moment.audit = {};
    moment.energy_reference =
        mechanical_energy(model, medium, moment.motion, moment.frame.kinematics);
    close_books(model, medium, moment);
}

}  // namespace cambrian
