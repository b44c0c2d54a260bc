// Of two opposite faces of a box, the one that leads feels the pressure p = -(k1 + k2 |u|) u, with
// the speed u of the surface along its normal. It is integrated over each pair of faces with the 3
// x 3 points of C. F. Gauss. Each point opposes its own motion, so drag never gives energy.

#include "spatial/forces.h"

#include <algorithm>
#include <cmath>

namespace cambrian::spatial {
namespace {

constexpr double kStation = 0.7745966692414834;  // sqrt(3/5)
constexpr double kStations[3] = {-kStation, 0.0, kStation};
constexpr double kShares[3] = {5.0 / 9, 8.0 / 9, 5.0 / 9};

double clamped(double x, double size) {
    return std::clamp(x, -size, size);
}

// Sets what is missing from the joints' coordinates to the targets, at a share of the tick. Balls
// miss a turn in the axes of the body; both their bends are first scaled back into the cone.
void find_missing(const Model& model, const Drive& drive, double share, const Motion& motion,
                  double* missing, double* target) {
    for (int d = 0; d < model.degree_count; ++d) {
        target[d] = drive.start[d] + share * (drive.end[d] - drive.start[d]);
        missing[d] = target[d] - motion.position[d];
    }
    for (int i = 0; i < model.ball_count; ++i) {
        const int b = model.balls[i];
        const int first = model.bodies[b].first_degree;
        BallAngles angles{target[first], target[first + 1], target[first + 2]};
        const double swing = angles.swing();
        const double most = model.degrees[first].high;
        if (swing > most) {
            angles.bend_z *= most / swing;
            angles.bend_y *= most / swing;
        }
        const Vec3 turn = turn_between(ball_attitude(model, motion, b), ball_attitude(angles));
        set_coordinate_vector(missing + first, {turn.z(), turn.y(), turn.x()});
    }
}

// The rate that a motor wants and its effort for each difference from it; what it wants in torque
// mode is an effort.
struct Wanted {
    double rate = 0.0;
    double gain = 0.0;
    double damping = 1.0;  // 0 in torque mode
};

Wanted wanted(const Degree& degree, const Drive& drive, double target, double missing) {
    if (degree.mode == MotorMode::kTorque)
        return {clamped(target, 1.0), drive.frequency > 0.0 ? degree.max_effort : 0.0, 0.0};
    const double fastest = degree.rate_scale * drive.speed_limit;
    const double asked =
        degree.mode == MotorMode::kPosition ? 0.5 * drive.frequency * missing : target;
    return {clamped(asked, fastest), 2.0 * degree.inertia * drive.frequency};
}

// Velocity and spin of a part in its own axes, and what drag gives it there.
struct Flow {
    Vec3 velocity, spin;
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    double power = 0.0;
};

// Adds the drag of the pair of faces along one axis.
void add_pair(const Medium& medium, const Vec3& half, int normal, Flow& flow) {
    const int a = (normal + 1) % 3;
    const int c = (normal + 2) % 3;
    const double area = half[a] * half[c];
    for (int i = 0; i < 3; ++i) {
        const double along_a = kStations[i] * half[a];
        for (int j = 0; j < 3; ++j) {
            const double along_c = kStations[j] * half[c];
            const double speed =
                flow.velocity[normal] + flow.spin[a] * along_c - flow.spin[c] * along_a;
            const double force = -(medium.drag_linear + medium.drag_quadratic * std::fabs(speed)) *
                                 speed * (kShares[i] * kShares[j] * area);
            flow.force[normal] += force;
            flow.moment[a] += along_c * force;
            flow.moment[c] -= along_a * force;
            flow.power += force * speed;
        }
    }
}

}  // namespace

MotorPower drive_joints(const Model& model, const Drive& drive, double share, const Motion& motion,
                        Loads& loads) {
    MotorPower power;
    double missing[kMostJointDegrees];
    double target[kMostJointDegrees];
    find_missing(model, drive, share, motion, missing, target);
    for (int d = 0; d < model.degree_count; ++d) {
        const Degree& degree = model.degrees[d];
        const double rate = motion.speed[d];
        const Wanted want = wanted(degree, drive, target[d], missing[d]);
        loads.effort[d] = clamped(want.gain * (want.rate - want.damping * rate), degree.max_effort);
        loads.damping[d] = 0.0;
        const double given = loads.effort[d] * rate;
        power.net += given;
        power.gross += std::fabs(given);
    }
    return power;
}

void drive_joints_implicitly(const Model& model, const Drive& drive, double share,
                             const Motion& start, const Motion& motion, double time, Loads& loads) {
    double missing[kMostJointDegrees];
    double target[kMostJointDegrees];
    find_missing(model, drive, share, motion, missing, target);
    for (int d = 0; d < model.degree_count; ++d) {
        const Degree& degree = model.degrees[d];
        const Wanted want = wanted(degree, drive, target[d], missing[d]);
        const double predicted = want.gain * (want.rate - want.damping * motion.speed[d]);
        if (std::fabs(predicted) < degree.max_effort) {
            loads.effort[d] = want.gain * (want.rate - want.damping * start.speed[d]);
            loads.damping[d] = time * want.gain * want.damping;
        } else {
            loads.effort[d] = clamped(predicted, degree.max_effort);
            loads.damping[d] = 0.0;
        }
    }
}

double add_drag(const Model& model, const Medium& medium, const Kinematics& k, const Vec3& drift,
                Loads& loads) {
    if (!(medium.drag_linear > 0.0 || medium.drag_quadratic > 0.0)) return 0.0;
    double power = 0.0;
    for (int p = 0; p < model.part_count; ++p) {
        const Part& part = model.parts[p];
        const int b = part.body;
        const Turn axes = k.turn[b] * part.turn;
        const Vec3 arm = k.turn[b] * part.place;
        Flow flow{axes.back(k.velocity[b] + cross(k.spin[b], arm) + drift), axes.back(k.spin[b])};
        for (int normal = 0; normal < 3; ++normal)
            add_pair(medium, part.half, normal, flow);
        const Vec3 force = axes * flow.force;
        loads.wrench[b] += {axes * flow.moment + cross(k.place[b] + arm, force), force};
        power += flow.power;
    }
    return power;
}

double add_pulls(const Forcing& forcing, const Kinematics& k, const Vec3& drift, Loads& loads) {
    double power = 0.0;
    for (int i = 0; i < forcing.pull_count; ++i) {
        const Pull& pull = forcing.pulls[i];
        const int b = pull.body;
        const Vec3 arm = k.turn[b] * pull.point;
        loads.wrench[b] += {cross(k.place[b] + arm, pull.force), pull.force};
        power += dot(pull.force, k.velocity[b] + cross(k.spin[b], arm) + drift);
    }
    return power;
}

}  // namespace cambrian::spatial
