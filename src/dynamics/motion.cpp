#include "dynamics/motion.h"

namespace cambrian {

Motion rest_motion(const PlanarModel& model) {
    Motion motion;
    motion.position[0] = model.rest_center_x;
    motion.position[1] = model.rest_center_y;
    motion.position[2] = model.rest_root_angle;
    PerBody angle = {};
    angle[0] = model.rest_root_angle;
    for (int i = 1; i < model.body_count; ++i) {
        angle[i] = angle[model.parent[i]] + model.rest_angle[i];
        const bool linear = model.joint[i] == JointType::kLinear;
        motion.position[coordinate_of(i)] = linear ? 0.0 : angle[i];
    }
    return motion;
}

}  // namespace cambrian
