#pragma once

// All numbers of a cache, for whatever copies or clears caches by the counts of their models.

#include "dynamics/evaluation/accelerations.h"
#include "dynamics/evaluation/number_counts.h"

#include <iterator>

namespace cambrian {

inline constexpr PerBody Kinematics::*kKinematicNumbers[] = {&Kinematics::angle,
                                                             &Kinematics::cosine,
                                                             &Kinematics::sine,
                                                             &Kinematics::x,
                                                             &Kinematics::y,
                                                             &Kinematics::velocity_x,
                                                             &Kinematics::velocity_y,
                                                             &Kinematics::spin,
                                                             &Kinematics::s_x,
                                                             &Kinematics::s_y,
                                                             &Kinematics::z_x,
                                                             &Kinematics::z_y,
                                                             &Kinematics::gamma_x,
                                                             &Kinematics::gamma_y,
                                                             &Kinematics::axis_x,
                                                             &Kinematics::axis_y,
                                                             &Kinematics::joint_position,
                                                             &Kinematics::joint_rate,
                                                             &Kinematics::length_growth,
                                                             &Kinematics::width_growth,
                                                             &Kinematics::stretch_rate,
                                                             &Kinematics::y_x,
                                                             &Kinematics::y_y};
inline constexpr PerBody Loads::*kLoadNumbers[] = {&Loads::force_x, &Loads::force_y, &Loads::torque,
                                                   &Loads::effort};
inline constexpr PerBody Factors::*kFactorNumbers[] = {&Factors::w_x, &Factors::w_y, &Factors::w_3,
                                                       &Factors::inverse_d, &Factors::damping};
inline constexpr PerBody BodyResponse::*kResponseNumbers[] = {&BodyResponse::x, &BodyResponse::y,
                                                              &BodyResponse::spin};

// A number that the lists leave out would be lost.
static_assert(sizeof(Kinematics) == std::size(kKinematicNumbers) * sizeof(PerBody) + 8);
static_assert(sizeof(Loads) == std::size(kLoadNumbers) * sizeof(PerBody));
static_assert(sizeof(Factors) ==
              std::size(kFactorNumbers) * sizeof(PerBody) + sizeof(Factors::root));
static_assert(sizeof(BodyResponse) ==
              std::size(kResponseNumbers) * sizeof(PerBody) + sizeof(PerCoordinate));

template <class Visitor>
void visit_motion(Motion& motion, const ChangedCounts& counts, Visitor& visitor) {
    visitor.lanes(motion.position, counts.now.coordinates, counts.before.coordinates);
    visitor.lanes(motion.speed, counts.now.coordinates, counts.before.coordinates);
    visitor.one(motion.work);
}

template <class Visitor>
void visit_rate(MotionRate& rate, const ChangedCounts& counts, Visitor& visitor) {
    visitor.lanes(rate.acceleration, counts.now.coordinates, counts.before.coordinates);
    visitor.one(rate.power);
}

template <class Visitor>
void visit_response(BodyResponse& response, const ChangedCounts& counts, Visitor& visitor) {
    visit_lanes(response, kResponseNumbers, counts.now.bodies, counts.before.bodies, visitor);
    visitor.lanes(response.coordinate, counts.now.coordinates, counts.before.coordinates);
}

template <class Visitor>
void visit_cache(EvaluationCache& cache, const ChangedCounts& counts, Visitor& visitor) {
    const int now = counts.now.bodies;
    const int before = counts.before.bodies;
    visitor.one(cache.kinematics.deforms);
    visitor.one(cache.has_centers);
    visitor.one(cache.has_joint_geometry);
    visitor.one(cache.is_factored);
    visitor.one(cache.is_inverted);
    visit_lanes(cache.kinematics, kKinematicNumbers, now, before, visitor);
    visit_lanes(cache.loads, kLoadNumbers, now, before, visitor);
    visit_lanes(cache.factors, kFactorNumbers, now, before, visitor);
    visitor.some(cache.factors.root, counts.now.trees, counts.before.trees);
    visit_response(cache.response, counts, visitor);
    visitor.lanes(cache.motor_effort, now, before);
    visitor.lanes(cache.motor_damping, now, before);
    visitor.lanes(cache.inverse, counts.now.dense_matrix, counts.before.dense_matrix);
}

}  // namespace cambrian
