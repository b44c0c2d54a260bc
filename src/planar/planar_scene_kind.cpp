#include "planar/integrators/builtin_integrators.h"
#include "planar/joints/builtin_joints.h"
#include "planar/model/planar_model.h"
#include "planar/planar_scene.h"
#include "planar/scene_copies.h"

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
