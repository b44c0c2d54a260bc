#pragma once

// A body plan as a MuJoCo model: a tree of hinges in the x-z plane under a root with two slides and
// a hinge, like MuJoCo's own planar walkers. Parts are boxes of equal depth with velocity
// actuators.

#include "bench/engine_kinds.h"

#include <cstddef>
#include <memory>
#include <mujoco/mujoco.h>
#include <string>

namespace cambrian::bench {

struct MujocoDeleter {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
    void operator()(mjData* data) const { mj_deleteData(data); }
};
using MujocoModel = std::unique_ptr<mjModel, MujocoDeleter>;
using MujocoData = std::unique_ptr<mjData, MujocoDeleter>;

// Returns the common name of a part's body, hinge and box.
std::string mujoco_name(std::size_t part);

// Ends the program if MuJoCo refuses the text.
MujocoModel load_mujoco_model(const std::string& text);

// The actuator of part i is number i - 1.
MujocoModel build_mujoco_model(const BodyPlan& plan, const Environment& environment,
                               const MujocoSettings& settings);

}  // namespace cambrian::bench
