#include "dynamics/integrators/builtin_integrators.h"
#include "dynamics/joints/builtin_joints.h"
#include "dynamics/model/planar_model.h"
#include "dynamics/planar_scene.h"
#include "dynamics/scene_copies.h"

namespace cambrian {

SceneKind planar_scene_kind() {
    SceneKind kind;
    kind.id = "planar";
    kind.label = "Planar articulated bodies";
    kind.joints = builtin_joints();
    for (const IntegratorKind& integrator : builtin_integrators().all())
        kind.integrators.push_back({integrator.id, integrator.label});
    kind.accurate_integrator = "dormand-prince";
    const SceneCopy copy = scene_copies().front();
    kind.make = copy.make;
    kind.join = copy.join;
    kind.largest_join = {kMaxBodies, kMaxTrees, kMaxParts};
    return kind;
}

}  // namespace cambrian
