#include "support/workload.h"

#include "support/body_plans.h"

namespace cambrian {

std::vector<Workload> all_workloads() {
    Environment air;
    air.has_ground = false;
    const Environment walk;
    return {{"air", air}, {"swim", open_water()}, {"walk", walk}};
}

}  // namespace cambrian
