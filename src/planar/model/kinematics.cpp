#include "planar/model/kinematics.h"

#include "core/assert.h"
#include "math/elementary.h"
#include "planar/model/stretching.h"

namespace cambrian {
namespace {

// Bodies behind prismatic joints turn with their parents; their coordinates are lengths.
CAMBRIAN_INLINE void turn_with_parents(const PlanarModel& model, Kinematics& k) {
    for (int i = 0; i < model.body_count; ++i) {
        if (model.motion[i] != JointMotion::kSlide) continue;
        const int p = model.parent[i];
        CAMBRIAN_TICK_ASSERT(p >= 0 && p < i, "a parent comes before its children");
        k.angle[i] = k.angle[p] + model.rest_angle[i];
        k.spin[i] = k.spin[p];
    }
}

CAMBRIAN_INLINE void compute_angles(const PlanarModel& model, const Motion& motion, Kinematics& k) {
    const int slots = round_up_to_lanes(model.body_count);
    for (int i = 0; i < slots; i += kLanes) {
        store_lanes(k.angle + i, load_lanes(motion.position + i));
        store_lanes(k.spin + i, load_lanes(motion.speed + i));
    }
    for (int i = model.body_count; i < slots; ++i) {
        k.angle[i] = 0.0;
        k.spin[i] = 0.0;
    }
    if (model.has_slides) turn_with_parents(model, k);
    for (int i = 0; i < slots; i += kLanes) {
        for (int lane = i; lane < i + kLanes; ++lane) {
            const SineCosine turn = sine_cosine_reduced(k.angle[lane]);
            k.sine[lane] = turn.sine;
            k.cosine[lane] = turn.cosine;
        }
    }
}

// s = -perp(b), z = perp(a), gamma = -w_p^2 a, with the arms b from the centre to the pivot and a
// from the parent's pivot to this one.
CAMBRIAN_INLINE void turn_joints(const PlanarModel& model, Kinematics& k, int first) {
    const int* parents = model.parent_slot + first;
    const Simd4d parent_cosine = gather(k.cosine, parents);
    const Simd4d parent_sine = gather(k.sine, parents);
    const Simd4d parent_spin = gather(k.spin, parents);
    const Simd4d parent_angle = gather(k.angle, parents);
    const Simd4d cosine = load_lanes(k.cosine + first);
    const Simd4d sine = load_lanes(k.sine + first);
    const Simd4d pivot_x = load_lanes(model.pivot_x + first);
    const Simd4d pivot_y = load_lanes(model.pivot_y + first);
    const Simd4dVector arm =
        turned({load_lanes(model.reach_x + first), load_lanes(model.reach_y + first)},
               parent_cosine, parent_sine);
    const Simd4d square = parent_spin * parent_spin;
    store_lanes(k.s_x + first, sine * pivot_x + cosine * pivot_y);
    store_lanes(k.s_y + first, sine * pivot_y - cosine * pivot_x);
    store_lanes(k.z_x + first, -arm.y);
    store_lanes(k.z_y + first, arm.x);
    store_lanes(k.gamma_x + first, -square * arm.x);
    store_lanes(k.gamma_y + first, -square * arm.y);
    store_lanes(k.joint_position + first,
                load_lanes(k.angle + first) - parent_angle - load_lanes(model.rest_angle + first));
    store_lanes(k.joint_rate + first, load_lanes(k.spin + first) - parent_spin);
}

// With the slide s and the arm a = R_p (reach + s e) - R_i b to the centre: z = perp(a),
// gamma = -w_p^2 a + 2 w_p s' perp(axis).
CAMBRIAN_INLINE void slide_joint(const PlanarModel& model, const Motion& motion, Kinematics& k,
                                 int i) {
    CAMBRIAN_TICK_ASSERT(model.motion[i] == JointMotion::kSlide, "a joint that slides");
    const int p = model.parent[i];
    const double slide = motion.position[i];
    const double rate = motion.speed[i];
    const double axis_x = k.cosine[p] * model.axis_x[i] - k.sine[p] * model.axis_y[i];
    const double axis_y = k.sine[p] * model.axis_x[i] + k.cosine[p] * model.axis_y[i];
    const double arm_x =
        k.z_y[i] + slide * axis_x -
        (k.cosine[i] * model.child_anchor_x[i] - k.sine[i] * model.child_anchor_y[i]);
    const double arm_y =
        -k.z_x[i] + slide * axis_y -
        (k.sine[i] * model.child_anchor_x[i] + k.cosine[i] * model.child_anchor_y[i]);
    const double spin = k.spin[p];
    k.axis_x[i] = axis_x;
    k.axis_y[i] = axis_y;
    k.z_x[i] = -arm_y;
    k.z_y[i] = arm_x;
    k.gamma_x[i] = -spin * spin * arm_x - 2.0 * spin * rate * axis_y;
    k.gamma_y[i] = -spin * spin * arm_y + 2.0 * spin * rate * axis_x;
    k.joint_position[i] = slide;
    k.joint_rate[i] = rate;
}

// Sums the offsets of the pivots from their parents' pivots down the trees, adds the lever of each
// centre, and shifts each tree so that its mean is the given centre. `lever` returns the levers of
// four bodies. The mean of the first tree is summed in the same pass, as most creatures are one.
template <class Lever>
CAMBRIAN_INLINE void sum_from_roots(const PlanarModel& model, const double* center,
                                    const Lever& lever, double* x, double* y) {
    const int slots = round_up_to_lanes(model.body_count);
    for (int t = 0; t < model.tree_count; ++t) {
        for (int i = model.tree_begin[t] + 1; i < model.tree_begin[t + 1]; ++i) {
            CAMBRIAN_TICK_ASSERT(model.parent[i] >= 0 && model.parent[i] < i,
                                 "a parent comes before its children");
            const int p = model.parent[i];
            x[i] += x[p];
            y[i] += y[p];
        }
    }
    Simd4dVector sums = {};
    const double* first_share = model.members_of(0).share;
    for (int i = 0; i < slots; i += kLanes) {
        const Simd4dVector levers = lever(i);
        const Simd4d moved_x = load_lanes(x + i) + levers.x;
        const Simd4d moved_y = load_lanes(y + i) + levers.y;
        store_lanes(x + i, moved_x);
        store_lanes(y + i, moved_y);
        add_weighted(first_share + i, moved_x, moved_y, sums);
    }
    for (int t = 0; t < model.tree_count; ++t) {
        const TreeMembers& members = model.members_of(t);
        if (t > 0) sums = weighted_sums(members.share, x, y, slots);
        const Simd4d shift_x = all_lanes(center[0] - sum_of(sums.x));
        const Simd4d shift_y = all_lanes(center[1] - sum_of(sums.y));
        center += 2;
        for (int i = 0; i < slots; i += kLanes) {
            const Simd4d member = load_lanes(members.membership + i);
            store_lanes(x + i, load_lanes(x + i) + member * shift_x);
            store_lanes(y + i, load_lanes(y + i) + member * shift_y);
        }
    }
}

// Pivots: v_i = v_p + w_p z, and + s' axis behind prismatic joints; centres: + w_i s.
CAMBRIAN_INLINE void move_bodies(const PlanarModel& model, const Kinematics& k, const double* rates,
                                 const double* spins, double* velocity_x, double* velocity_y) {
    for (int i = 0; i < model.body_count; i += kLanes) {
        const Simd4d parent_spin = gather(spins, model.parent_slot + i);
        store_lanes(velocity_x + i, parent_spin * load_lanes(k.z_x + i));
        store_lanes(velocity_y + i, parent_spin * load_lanes(k.z_y + i));
    }
    for (int i = 0; model.has_slides && i < model.body_count; ++i) {
        if (model.motion[i] != JointMotion::kSlide) continue;
        velocity_x[i] += rates[i] * k.axis_x[i];
        velocity_y[i] += rates[i] * k.axis_y[i];
    }
    const auto lever = [&](int i) {
        const Simd4d spin = load_lanes(spins + i);
        return Simd4dVector{spin * load_lanes(k.s_x + i), spin * load_lanes(k.s_y + i)};
    };
    sum_from_roots(model, rates + center_of(model, 0), lever, velocity_x, velocity_y);
}

}  // namespace

void compute_joints(const PlanarModel& model, const Motion& motion, Kinematics& k) {
    if (model.stretch_count > 0) return compute_stretched_joints(model, motion, k);
    compute_angles(model, motion, k);
    for (int first = 0; first < model.body_count; first += kLanes)
        turn_joints(model, k, first);
    if (!model.has_slides) return;
    for (int i = 0; i < model.body_count; ++i) {
        if (model.motion[i] == JointMotion::kSlide) slide_joint(model, motion, k, i);
    }
}

void compute_joint_geometry(const PlanarModel& model, Kinematics& k) {
    for (int first = 0; first < model.body_count; first += kLanes)
        turn_joints(model, k, first);
}

void compute_velocities(const PlanarModel& model, const Motion& motion, Kinematics& k) {
    if (model.stretch_count > 0)
        return move_stretched_bodies(model, k, motion.speed, k.spin, k.velocity_x, k.velocity_y);
    move_bodies(model, k, motion.speed, k.spin, k.velocity_x, k.velocity_y);
}

void spread_spins(const PlanarModel& model, const PerCoordinate& rates, PerBody& spin) {
    if (model.stretch_count > 0) return spread_stretched_spins(model, rates, spin);
    const int slots = round_up_to_lanes(model.body_count);
    for (int i = 0; i < slots; i += kLanes)
        store_lanes(spin + i, load_lanes(rates + i));
    for (int i = model.body_count; i < slots; ++i)
        spin[i] = 0.0;
    for (int i = 0; model.has_slides && i < model.body_count; ++i) {
        if (model.motion[i] == JointMotion::kSlide) spin[i] = spin[model.parent[i]];
    }
}

void spread_rates(const PlanarModel& model, const Kinematics& place, const PerCoordinate& rates,
                  PerBody& spin, PerBody& velocity_x, PerBody& velocity_y) {
    spread_spins(model, rates, spin);
    if (model.stretch_count > 0)
        return move_stretched_bodies(model, place, rates, spin, velocity_x, velocity_y);
    move_bodies(model, place, rates, spin, velocity_x, velocity_y);
}

// Pivots: c_i = c_p - perp(z); centres: - perp(s).
void compute_places(const PlanarModel& model, const Motion& motion, Kinematics& k) {
    if (model.stretch_count > 0) return place_stretched_bodies(model, motion, k);
    for (int i = 0; i < model.body_count; i += kLanes) {
        store_lanes(k.x + i, load_lanes(k.z_y + i));
        store_lanes(k.y + i, -load_lanes(k.z_x + i));
    }
    const auto lever = [&](int i) {
        return Simd4dVector{load_lanes(k.s_y + i), -load_lanes(k.s_x + i)};
    };
    sum_from_roots(model, motion.position + center_of(model, 0), lever, k.x, k.y);
}

void compute_kinematics(const PlanarModel& model, const Motion& motion, Kinematics& kinematics) {
    compute_joints(model, motion, kinematics);
    compute_velocities(model, motion, kinematics);
    compute_places(model, motion, kinematics);
}

double limit_overrun(const PlanarModel& model, const Kinematics& k) {
    Simd4d overrun = {};
    for (int i = 0; i < model.body_count; i += kLanes) {
        const Simd4d position = load_lanes(k.joint_position + i);
        overrun = greater(overrun, load_lanes(model.limit_low + i) - position);
        overrun = greater(overrun, position - load_lanes(model.limit_high + i));
    }
    CAMBRIAN_TICK_ASSERT(!(largest_of(overrun) < 0.0), "an overrun is not negative");
    return largest_of(overrun);
}

double kinetic_energy(const PlanarModel& model, const Kinematics& k) {
    if (model.stretch_count > 0) return stretched_kinetic_energy(model, k);
    Simd4d energy = {};
    for (int i = 0; i < model.body_count; i += kLanes) {
        energy += doubled_energies(model, load_lanes(k.velocity_x + i),
                                   load_lanes(k.velocity_y + i), load_lanes(k.spin + i), i);
    }
    CAMBRIAN_TICK_ASSERT(!(sum_of(energy) < 0.0), "a kinetic energy is not negative");
    return 0.5 * sum_of(energy);
}

namespace {

// If every body is one box, positions of boxes are those of bodies.
CAMBRIAN_INLINE void place_single_boxes(const PlanarModel& model, const Kinematics& k,
                                        PartPlaces& places) {
    for (int first = 0; first < model.part_count; first += kLanes) {
        const int* bodies = model.part_body + first;
        store_lanes(places.x + first, gather(k.x, bodies));
        store_lanes(places.y + first, gather(k.y, bodies));
        store_lanes(places.axis_x + first, gather(k.cosine, bodies));
        store_lanes(places.axis_y + first, gather(k.sine, bodies));
    }
}

// Sets the present half extents.
CAMBRIAN_INLINE void size_parts(const PlanarModel& model, const Kinematics& k, PartPlaces& places) {
    use_sizes(model, places);
    if (model.stretch_count == 0) return;
    for (int part = 0; part < round_up_to_lanes(model.part_count); ++part) {
        const int b = model.part_body[part];
        places.stretched_length[part] = k.length_growth[b] * model.half_length[part];
        places.stretched_width[part] = k.width_growth[b] * model.half_width[part];
    }
}

}  // namespace

void place_parts(const PlanarModel& model, const Kinematics& k, PartPlaces& places) {
    size_parts(model, k, places);
    if (has_single_boxes(model)) return place_single_boxes(model, k, places);
    for (int first = 0; first < model.part_count; first += kLanes) {
        const int* bodies = model.part_body + first;
        const PartLanes parts = part_lanes(model, k, first);
        const Simd4dVector& offset = parts.offset;
        const Simd4dVector axis = part_axes(model, parts, first);
        store_lanes(places.x + first,
                    gather(k.x, bodies) + parts.cosine * offset.x - parts.sine * offset.y);
        store_lanes(places.y + first,
                    gather(k.y, bodies) + parts.sine * offset.x + parts.cosine * offset.y);
        store_lanes(places.axis_x + first, axis.x);
        store_lanes(places.axis_y + first, axis.y);
    }
}

}  // namespace cambrian
