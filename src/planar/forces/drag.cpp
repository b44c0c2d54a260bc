#include "planar/forces/drag.h"

#include "core/assert.h"
#include "planar/model/stretching.h"

#include <algorithm>

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

namespace {

// The medium's force along the outward normal of a face, N, the sum of force times place along the
// face, N m, and the power, W.
struct FacePress {
    double force = 0.0, moment = 0.0, power = 0.0;
};

// `speed` is the outward normal speed at the middle of the face, `slope` its change along it.
FacePress press_face(const Medium& medium, double speed, double slope, double half) {
    using namespace box_drag_detail;
    constexpr double kPlaces[3] = {-kNode, 0.0, kNode};
    constexpr double kWeights[3] = {kEndWeight, kMiddleWeight, kEndWeight};
    FacePress press;
    for (int node = 0; node < 3; ++node) {
        const double place = kPlaces[node] * half;
        const double w = std::max(0.0, speed + slope * place);
        const double force =
            -kWeights[node] * half * (medium.drag_linear + medium.drag_quadratic * w) * w;
        press.force += force;
        press.moment += force * place;
        press.power += force * w;
    }
    return press;
}

struct PartDrag {
    double along = 0.0, across = 0.0;  // N
    double moment = 0.0;               // N m
    double stretch = 0.0;              // N m, on the body's stretch
    double power = 0.0;                // W
};

// The velocity of the part's centre in its own frame.
struct PartMotion {
    double along, across;  // m/s
    double spin;           // rad/s
    double stretch_rate;   // 1/s
    double half_length, half_width;
};

PartDrag drag_part(const Medium& medium, const PartMotion& part) {
    const double a = part.half_length;
    const double b = part.half_width;
    const double widening = -part.stretch_rate * b;
    const double lengthening = part.stretch_rate * a;
    const FacePress left = press_face(medium, part.across + widening, part.spin, a);
    const FacePress right = press_face(medium, -part.across + widening, -part.spin, a);
    const FacePress distal = press_face(medium, part.along + lengthening, -part.spin, b);
    const FacePress proximal = press_face(medium, -part.along + lengthening, part.spin, b);
    return {distal.force - proximal.force, left.force - right.force,
            left.moment - right.moment - distal.moment + proximal.moment,
            a * (distal.force + proximal.force) - b * (left.force + right.force),
            left.power + right.power + distal.power + proximal.power};
}

}  // namespace

double add_stretched_drag(const PlanarModel& model, const Medium& medium, const Kinematics& k,
                          Loads& loads) {
    double power = 0.0;
    for (int part = 0; part < model.part_count; ++part) {
        const int body = model.part_body[part];
        const Simd2d arm = material_arm(k, body, model.part_x[part], model.part_y[part]);
        const double axis_x =
            k.cosine[body] * model.part_cosine[part] - k.sine[body] * model.part_sine[part];
        const double axis_y =
            k.sine[body] * model.part_cosine[part] + k.cosine[body] * model.part_sine[part];
        const double velocity_x = k.velocity_x[body] - k.spin[body] * arm[1];
        const double velocity_y = k.velocity_y[body] + k.spin[body] * arm[0];
        const PartDrag drag = drag_part(
            medium,
            {axis_x * velocity_x + axis_y * velocity_y, axis_x * velocity_y - axis_y * velocity_x,
             k.spin[body], k.stretch_rate[body], k.length_growth[body] * model.half_length[part],
             k.width_growth[body] * model.half_width[part]});
        const double force_x = axis_x * drag.along - axis_y * drag.across;
        const double force_y = axis_y * drag.along + axis_x * drag.across;
        loads.force_x[body] += force_x;
        loads.force_y[body] += force_y;
        loads.torque[body] += drag.moment + arm[0] * force_y - arm[1] * force_x;
        if (const int slot = model.stretch_slot[body]; slot >= 0)
            loads.effort[slot] += drag.stretch;
        power += drag.power;
    }
    return power;
}

}  // namespace cambrian
