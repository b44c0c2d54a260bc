#include "dynamics/model/motion.h"

namespace cambrian {

Motion rest_motion(const PlanarModel& model) {
    Motion motion = {};
    PerBody angle = {};
    for (int t = 0; t < model.tree_count; ++t) {
        motion.position[center_of(model, t)] = model.rest_center_x[t];
        motion.position[center_of(model, t) + 1] = model.rest_center_y[t];
        const int root = model.tree_begin[t];
        angle[root] = model.rest_root_angle[t];
        motion.position[root] = angle[root];
        for (int i = root + 1; i < model.tree_begin[t + 1]; ++i) {
            angle[i] = angle[model.parent[i]] + model.rest_angle[i];
            motion.position[i] = model.motion[i] == JointMotion::kTurn ? angle[i] : 0.0;
        }
    }
    return motion;
}

}  // namespace cambrian
