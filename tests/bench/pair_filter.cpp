#include "bench/pair_filter.h"

#include "core/assert.h"
#include "planar/model_building.h"

namespace cambrian::bench {

PairFilter::PairFilter(const BodyPlan& plan)
    : parts_(plan.parts.size()), touching_(parts_ * parts_, false) {
    const Result<PlanarModel> model = build_planar_model(plan, 1.0);
    CAMBRIAN_ASSERT(model.has_value(), "benchmark bodies are valid");
    for (const PartPair& pair : model->colliding_pairs) {
        touching_[pair.first * parts_ + pair.second] = true;
        touching_[pair.second * parts_ + pair.first] = true;
    }
}

}  // namespace cambrian::bench
