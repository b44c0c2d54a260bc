#include "planar/scene_copies.h"

namespace cambrian {

std::vector<SceneCopy> scene_copies() {
    std::vector<SceneCopy> copies;
#ifdef CAMBRIAN_HAS_AVX2_COPY
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") &&
        __builtin_cpu_supports("bmi2"))
        copies.push_back({avx2::make_planar_scene, avx2::join_planar_scenes});
#endif
    copies.push_back({baseline::make_planar_scene, baseline::join_planar_scenes});
    return copies;
}

}  // namespace cambrian
