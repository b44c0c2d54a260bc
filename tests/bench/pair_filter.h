#pragma once

// The pairs of parts that may collide by the rules of our physics, for the other engines.

#include "world/body_plan.h"

#include <cstddef>
#include <vector>

namespace cambrian::bench {

class PairFilter {
public:
    explicit PairFilter(const BodyPlan& plan);

    bool may_touch(std::size_t a, std::size_t b) const { return touching_[a * parts_ + b]; }

private:
    std::size_t parts_;
    std::vector<bool> touching_;
};

}  // namespace cambrian::bench
