#pragma once

// Deformable bodies (planar/README.md 20). A point X of the rest shape, in the body's frame, is
// at r = R D X from the centre, with D = diag(e^s, e^-s) of the stretch s. With K = diag(1, -1) it
// has
//     velocity      v = c' + w perp(r) + s' kappa(r),     kappa(r) = R K R^T r
//     acceleration  a = c'' + w' perp(r) + s'' kappa(r) + beta(r),
//     beta(r) = (s'^2 - w^2) r + 2 w s' perp(kappa(r)).
// In models with stretches the pivot of every body is its own centre, z is the velocity of the
// joint per unit spin of the parent, s that of the centre per unit spin of the body and, in the
// slot of a stretch, that of the body's centre per unit stretch rate.

#include "planar/model/kinematics.h"
#include "planar/model/planar_model.h"

namespace cambrian {

// Moves a point of the body's rest shape to where it is in the body's frame.
CAMBRIAN_INLINE void stretch_point(const Kinematics& k, int body, double& x, double& y) {
    if (!k.deforms) return;
    x *= k.length_growth[body];
    y *= k.width_growth[body];
}

// Returns the world offset from the body's centre of a point of its rest shape.
CAMBRIAN_INLINE Simd2d material_arm(const Kinematics& k, int body, double x, double y) {
    stretch_point(k, body, x, y);
    return Simd2d{k.cosine[body] * x - k.sine[body] * y, k.sine[body] * x + k.cosine[body] * y};
}

// Returns kappa of a world offset from the body's centre.
CAMBRIAN_INLINE Simd2d stretch_lever(const Kinematics& k, int body, double arm_x, double arm_y) {
    const double cosine = k.cosine[body] * k.cosine[body] - k.sine[body] * k.sine[body];
    const double sine = 2.0 * k.sine[body] * k.cosine[body];
    return Simd2d{cosine * arm_x + sine * arm_y, sine * arm_x - cosine * arm_y};
}

// Returns the velocity of a point at this world offset that the body's stretching makes, in m/s.
CAMBRIAN_INLINE Simd2d stretch_velocity(const Kinematics& k, int body, double arm_x, double arm_y) {
    return both(k.stretch_rate[body]) * stretch_lever(k, body, arm_x, arm_y);
}

// Returns what beta has besides the centripetal acceleration -w^2 r of rigid bodies.
CAMBRIAN_INLINE Simd2d stretch_bias(const Kinematics& k, int body, double arm_x, double arm_y) {
    const double rate = k.stretch_rate[body];
    const Simd2d lever = stretch_lever(k, body, arm_x, arm_y);
    const double turn = 2.0 * k.spin[body] * rate;
    return Simd2d{rate * rate * arm_x - turn * lever[1], rate * rate * arm_y + turn * lever[0]};
}

// The principal parts of a body's moment of inertia, kg m^2: their sum is its inertia and the mass
// of its stretch, I(s).
struct InertiaParts {
    double length, width;
};
CAMBRIAN_INLINE InertiaParts inertia_parts(const PlanarModel& model, const Kinematics& k,
                                           int body) {
    const double length = k.length_growth[body] * k.length_growth[body];
    const double width = k.width_growth[body] * k.width_growth[body];
    return {model.mass[body] * model.length_square[body] * length,
            model.mass[body] * model.width_square[body] * width};
}

// The moment of inertia of a body about its centre, kg m^2; 0 in the slot of a stretch.
CAMBRIAN_INLINE double present_inertia(const PlanarModel& model, const Kinematics& k, int body) {
    if (model.motion[body] == JointMotion::kStretch) return 0.0;
    if (model.stretch_slot[body] < 0) return model.inertia[body];
    const InertiaParts parts = inertia_parts(model, k, body);
    return parts.length + parts.width;
}

// Do what the functions of kinematics.h do, for models with stretches.
void compute_stretched_joints(const PlanarModel& model, const Motion& motion, Kinematics& k);
void place_stretched_bodies(const PlanarModel& model, const Motion& motion, Kinematics& k);
void spread_stretched_spins(const PlanarModel& model, const PerCoordinate& rates, PerBody& spin);
// Fills the velocities of the centres for any rates of the coordinates and their spins.
void move_stretched_bodies(const PlanarModel& model, const Kinematics& k,
                           const PerCoordinate& rates, const PerBody& spin, PerBody& velocity_x,
                           PerBody& velocity_y);
double stretched_kinetic_energy(const PlanarModel& model, const Kinematics& k);  // J

}  // namespace cambrian
