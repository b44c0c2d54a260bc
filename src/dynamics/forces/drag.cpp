#include "dynamics/forces/drag.h"

#include "core/assert.h"
#include "dynamics/forces/box_drag.h"
#include "dynamics/forces/stretched_drag.h"

namespace cambrian {

double add_drag(const PlanarModel& model, const Medium& medium, const Kinematics& k, Loads& loads) {
    if (model.stretch_count > 0) return add_stretched_drag(model, medium, k, loads);
    Simd4d power = {};
    for (int first = 0; first < model.part_count; first += kLanes) {
        CAMBRIAN_TICK_ASSERT(medium.drag_linear >= 0.0 && medium.drag_quadratic >= 0.0,
                             "drag resists");
        const PartLanes parts = part_lanes(model, k, first);
        const BoxDrag drag = drag_boxes(
            medium, {part_axes(model, parts, first), part_velocities(model, k, parts, first),
                     gather(k.spin, model.part_body + first), load_lanes(model.half_length + first),
                     load_lanes(model.half_width + first)});
        const Simd4d torque = drag.moment + parts.arm.x * drag.force_y - parts.arm.y * drag.force_x;
        power += drag.power;
        // Parts beyond the count have no size and no drag.
        for (int lane = 0; lane < kLanes; ++lane) {
            const int b = model.part_body[first + lane];
            loads.force_x[b] += drag.force_x[lane];
            loads.force_y[b] += drag.force_y[lane];
            loads.torque[b] += torque[lane];
        }
    }
    return sum_of(power);
}

}  // namespace cambrian
