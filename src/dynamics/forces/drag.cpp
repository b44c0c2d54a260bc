#include "dynamics/forces/drag.h"

#include "core/assert.h"
#include "dynamics/forces/box_drag.h"
#include "dynamics/forces/stretched_drag.h"

namespace cambrian {
namespace {

// Returns the drag of four boxes at these arms from the centres of their bodies, with the moment
// about these centres.
CAMBRIAN_INLINE BoxDrag drag_on_bodies(const Medium& medium, const BoxMotion& box,
                                       const Simd4dVector& arm) {
    CAMBRIAN_TICK_ASSERT(medium.drag_linear >= 0.0 && medium.drag_quadratic >= 0.0, "drag resists");
    BoxDrag drag = drag_boxes(medium, box);
    drag.moment = drag.moment + arm.x * drag.force_y - arm.y * drag.force_x;
    return drag;
}

CAMBRIAN_INLINE void add_lanes(double* to, const Simd4d& lanes) {
    store_lanes(to, load_lanes(to) + lanes);
}

// Returns the sum of bodies' numbers in the order of their boxes.
CAMBRIAN_INLINE double sum_by_boxes(const PlanarModel& model, const PerBody& numbers) {
    Simd4d sum = {};
    for (int first = 0; first < model.part_count; first += kLanes) {
        const Simd4i is_box = Simd4i{0, 1, 2, 3} < std::int64_t{model.part_count - first};
        sum += is_box ? gather(numbers, model.part_body + first) : Simd4d{};
    }
    return sum_of(sum);
}

// The same as add_welded_drag, four bodies at once, where every body is one box.
CAMBRIAN_INLINE double add_single_drag(const PlanarModel& model, const Medium& medium,
                                       const Kinematics& k, Loads& loads) {
    PerBody power;
    for (int i = 0; i < model.body_count; i += kLanes) {
        const Simd4dVector axis = {load_lanes(k.cosine + i), load_lanes(k.sine + i)};
        const Simd4dVector arm =
            turned({load_lanes(model.box_x + i), load_lanes(model.box_y + i)}, axis.x, axis.y);
        const Simd4dVector velocity = {load_lanes(k.velocity_x + i), load_lanes(k.velocity_y + i)};
        const Simd4d spin = load_lanes(k.spin + i);
        const BoxDrag drag = drag_on_bodies(
            medium,
            {axis, velocities_at(arm, velocity, spin), spin, load_lanes(model.box_half_length + i),
             load_lanes(model.box_half_width + i)},
            arm);
        add_lanes(loads.force_x + i, drag.force_x);
        add_lanes(loads.force_y + i, drag.force_y);
        add_lanes(loads.torque + i, drag.moment);
        store_lanes(power + i, drag.power);
    }
    return sum_by_boxes(model, power);
}

CAMBRIAN_INLINE double add_welded_drag(const PlanarModel& model, const Medium& medium,
                                       const Kinematics& k, Loads& loads) {
    Simd4d power = {};
    for (int first = 0; first < model.part_count; first += kLanes) {
        const int* bodies = model.part_body + first;
        const PartLanes parts = part_lanes(model, k, first);
        const BoxDrag drag =
            drag_on_bodies(medium,
                           {part_axes(model, parts, first), part_velocities(model, k, parts, first),
                            gather(k.spin, bodies), load_lanes(model.half_length + first),
                            load_lanes(model.half_width + first)},
                           parts.arm);
        power += drag.power;
        // Parts beyond the count have no size and no drag.
        for (int lane = 0; lane < kLanes; ++lane) {
            const int b = bodies[lane];
            loads.force_x[b] += drag.force_x[lane];
            loads.force_y[b] += drag.force_y[lane];
            loads.torque[b] += drag.moment[lane];
        }
    }
    return sum_of(power);
}

}  // namespace

double add_drag(const PlanarModel& model, const Medium& medium, const Kinematics& k, Loads& loads) {
    if (model.stretch_count > 0) return add_stretched_drag(model, medium, k, loads);
    if (has_single_boxes(model)) return add_single_drag(model, medium, k, loads);
    return add_welded_drag(model, medium, k, loads);
}

}  // namespace cambrian
