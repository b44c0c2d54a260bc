#include "bench/workload.h"

namespace cambrian::bench {

std::vector<Workload> all_workloads() {
    Environment air;
    air.has_ground = false;
    Environment swim = air;
    swim.gravity = 0.0;
    swim.viscosity_linear = 0.5;
    swim.viscosity_quadratic = 5.0;
    const Environment walk;
    return {{"air", air}, {"swim", swim}, {"walk", walk}};
}

}  // namespace cambrian::bench
