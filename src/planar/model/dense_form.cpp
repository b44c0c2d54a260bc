#include "planar/model/dense_form.h"

#include "core/assert.h"
#include "planar/model/planar_model.h"

namespace cambrian {
namespace {

struct Arm {
    double x = 0.0, y = 0.0;  // m
};
using Arms = Arm[kMaxDenseBodies][kMaxDenseBodies];  // from an angle to a body

bool applies(const PlanarModel& model) {
    if (model.tree_count != 1 || model.body_count > kMaxDenseBodies) return false;
    for (int i = 1; i < model.body_count; ++i) {
        if (model.motion[i] != JointMotion::kTurn) return false;
    }
    return true;
}

// Sums the arms from the root's centre to each body, then refers them to the centre of mass.
void find_arms(const PlanarModel& model, Arms& arms) {
    for (int body = 0; body < model.body_count; ++body) {
        arms[body][body] = {-model.pivot_x[body], -model.pivot_y[body]};
        for (int child = body; model.parent[child] >= 0; child = model.parent[child])
            arms[model.parent[child]][body] = {model.reach_x[child], model.reach_y[child]};
    }
    for (int angle = 0; angle < model.body_count; ++angle) {
        Arm mean;
        for (int body = 0; body < model.body_count; ++body) {
            mean.x += model.members_of(0).share[body] * arms[angle][body].x;
            mean.y += model.members_of(0).share[body] * arms[angle][body].y;
        }
        for (int body = 0; body < model.body_count; ++body) {
            arms[angle][body].x -= mean.x;
            arms[angle][body].y -= mean.y;
        }
    }
}

}  // namespace

void derive_dense_form(const PlanarModel& model, DenseForm& form) {
    form = {};
    if (!applies(model)) return;
    form.blocks = round_up_to_lanes(model.body_count) / kLanes;
    CAMBRIAN_TICK_ASSERT(form.blocks > 0 && form.blocks * kLanes <= kMaxDenseBodies, "few bodies");
    const int lines = form.blocks * kLanes;
    const int count = model.body_count;
    Arms arms = {};
    find_arms(model, arms);
    for (int i = count; i < lines; ++i)
        form.inertia_cosine[i * lines + i] = 1.0;
    for (int j = 0; j < count; ++j) {
        form.inertia_cosine[j * lines + j] = model.inertia[j];
        for (int i = 0; i < count; ++i) {
            form.arm_x[j * lines + i] = arms[j][i].x;
            form.arm_y[j * lines + i] = arms[j][i].y;
            form.lever_x[j * lines + i] = arms[i][j].x;
            form.lever_y[j * lines + i] = arms[i][j].y;
            for (int body = 0; body < count; ++body) {
                const Arm& first = arms[i][body];
                const Arm& second = arms[j][body];
                form.inertia_cosine[j * lines + i] +=
                    model.mass[body] * (first.x * second.x + first.y * second.y);
                form.inertia_sine[j * lines + i] +=
                    model.mass[body] * (first.x * second.y - first.y * second.x);
            }
        }
    }
}

}  // namespace cambrian
