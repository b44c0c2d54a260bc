#include "planar/model/planar_model.h"

#include "core/assert.h"

#include <algorithm>

namespace cambrian {

void order_by_depth(PlanarModel& model) {
    int depth[kMaxBodies];
    int deepest = 0;
    for (int i = 0; i < model.body_count; ++i) {
        const int p = model.parent[i];
        CAMBRIAN_TICK_ASSERT(p < i, "a parent comes before its children");
        depth[i] = p < 0 ? 0 : depth[p] + 1;
        deepest = std::max(deepest, depth[i]);
    }
    int count = 0;
    for (int level = 0; level <= deepest; ++level) {
        for (int i = 0; i < model.body_count; ++i) {
            if (depth[i] == level) model.by_depth[count++] = i;
        }
    }
}

void derive_inertias(PlanarModel& model) {
    for (int i = 0; i < model.body_count; ++i) {
        if (model.motion[i] == JointMotion::kStretch) continue;
        CAMBRIAN_TICK_ASSERT(model.mass[i] > 0.0 && model.inertia[i] > 0.0, "a body has a mass");
        const double arm_square =
            model.pivot_x[i] * model.pivot_x[i] + model.pivot_y[i] * model.pivot_y[i];
        model.pivot_inertia[i] = model.inertia[i] + model.mass[i] * arm_square;
        model.inverse_mass[i] = 1.0 / model.mass[i];
        model.inverse_inertia[i] = 1.0 / model.inertia[i];
    }
    derive_dense_form(model, model.dense);
}

void change_density(PlanarModel& model, double density) {
    CAMBRIAN_TICK_ASSERT(density > 0.0 && model.density > 0.0, "a density is positive");
    const double ratio = density / model.density;
    model.density = density;
    model.total_mass *= ratio;
    for (double& mass : model.tree_mass)
        mass *= ratio;
    for (int i = 0; i < model.body_count; ++i) {
        model.mass[i] *= ratio;
        model.inertia[i] *= ratio;
        model.effective_inertia[i] *= ratio;
        model.motor.stiffness[i] *= ratio;
    }
    derive_inertias(model);
}

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
