#include "bench/engine_kinds.h"

namespace cambrian::bench {

std::vector<EngineKind> all_engines() {
    return {planar_engine("cambrian", {}), box2d_engine("box2d", {}), mujoco_engine("mujoco", {})};
}

}  // namespace cambrian::bench
