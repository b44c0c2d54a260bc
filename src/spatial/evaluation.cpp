#include "spatial/evaluation.h"

namespace cambrian::spatial {

void evaluate(const Model& model, const Forcing& forcing, const Motion& motion, double share,
              Evaluation& evaluation, MotionRate& rate, const ImplicitStage* implicit) {
    Kinematics& k = evaluation.kinematics;
    Loads& loads = evaluation.loads;
    const int attitude = model.attitude();
    const int place = model.place();
    compute_kinematics(model, motion, k);
    for (int b = 0; b < model.body_count; ++b)
        loads.wrench[b] = {};
    const Vec3 drift = coordinate_vector(motion.speed + place);
    rate.power[kDragWork] = add_drag(model, forcing.medium, k, drift, loads);
    rate.power[kPullWork] = add_pulls(forcing, k, drift, loads);
    if (implicit != nullptr) {
        drive_joints_implicitly(model, forcing.drive, share, implicit->start, motion,
                                implicit->time, loads);
    } else {
        const MotorPower power = drive_joints(model, forcing.drive, share, motion, loads);
        rate.power[kMotorWork] = power.net;
        rate.power[kGrossMotorWork] = power.gross;
    }
    solve_accelerations(model, k, loads, evaluation.factors, evaluation.response);
    for (int d = 0; d < model.degree_count; ++d) {
        rate.position[d] = motion.speed[d];
        rate.speed[d] = evaluation.response.joint[d];
    }
    for (int i = 0; i < model.ball_count; ++i) {
        const int first = model.bodies[model.balls[i]].first_degree;
        // Of an attitude Q exp(chart), with the spin in the inner axes.
        const Vec3 chart =
            chart_rate(-ball_vector(motion.position + first), ball_vector(motion.speed + first));
        set_coordinate_vector(rate.position + first, {chart.z(), chart.y(), chart.x()});
    }
    Six whole;
    for (int b = 0; b < model.body_count; ++b)
        whole += loads.wrench[b];
    set_coordinate_vector(rate.position + attitude,
                          chart_rate(coordinate_vector(motion.position + attitude), k.spin[0]));
    set_coordinate_vector(rate.position + place, drift);
    set_coordinate_vector(rate.speed + attitude, whole.angular);
    set_coordinate_vector(rate.speed + place, forcing.medium.gravity + whole.linear / model.mass);
    rate.root_turning = evaluation.response.root_turning();
}

double mechanical_energy(const Model& model, const Medium& medium, const Motion& motion,
                         const Kinematics& k) {
    return kinetic_energy(model, motion, k) -
           model.mass * dot(medium.gravity, coordinate_vector(motion.position + model.place()));
}

}  // namespace cambrian::spatial
