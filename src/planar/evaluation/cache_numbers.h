#pragma once

// All numbers of a cache, for whatever copies or clears caches by the counts of their models.

#include "planar/evaluation/accelerations.h"
#include "planar/model/planar_model.h"

#include <algorithm>
#include <iterator>

namespace cambrian {

// Counts of a model's numbers of each kind. Memory that serves several models in turn is filled
// and cleared by these counts.

struct NumberCounts {
    int bodies = 0, coordinates = 0, parts = 0, trees = 0;
    int members = 0;       // begins of members and the end of the last; 0 for one creature
    int measured = 0;      // parts whose forces are measured
    int dense_matrix = 0;  // numbers of a matrix of the dense form

    friend bool operator==(const NumberCounts&, const NumberCounts&) = default;
};

inline NumberCounts counts_of(const PlanarModel& model) {
    const bool is_dense = model.dense.blocks > 0;
    return {.bodies = model.body_count,
            .coordinates = coordinate_count(model),
            .parts = model.part_count,
            .trees = model.tree_count,
            .members = model.member_count > 1 ? model.member_count + 1 : 0,
            .measured = model.measured_parts != 0 ? model.part_count : 0,
            .dense_matrix = is_dense ? kMaxDenseBodies * kMaxDenseBodies : 0};
}

// Returns counts that are rounded up to the vector width where vectors are used.
inline NumberCounts lanes_of(NumberCounts counts) {
    for (int* count : {&counts.bodies, &counts.coordinates, &counts.parts, &counts.measured})
        *count = round_up_to_lanes(*count);
    return counts;
}

// The counts of the present model, and of the one that used the same memory before.
struct ChangedCounts {
    NumberCounts now, before;
};

// Visits numbers of doubles that vectors use, one field of `owner` after the other. A visitor has
// three functions: one(number), some(numbers, count, before), and lanes() for some() of these.
template <class Fields, class Owner, class Visitor>
void visit_lanes(Owner& owner, const Fields& fields, int now, int before, Visitor& visitor) {
    for (const auto field : fields)
        visitor.lanes(owner.*field, now, before);
}

// A visitor that sets what was used before, beyond the counts, to 0.
class Clearing {
public:
    template <class Number>
    void one(const Number&) {}
    void lanes(double* numbers, int count, int before) { some(numbers, count, before); }
    template <class Number>
    void some(Number* numbers, int count, int before) {
        if (before > count) std::fill(numbers + count, numbers + before, Number{});
    }
};

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
