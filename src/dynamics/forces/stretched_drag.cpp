#include "dynamics/forces/stretched_drag.h"

#include "dynamics/forces/box_drag.h"
#include "dynamics/model/stretching.h"

#include <algorithm>

namespace cambrian {
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
