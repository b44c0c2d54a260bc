#pragma once

// Checks that physics rejects a body plan for a given reason.

#include "planar/model_building.h"

#include <string>

namespace cambrian::test {

inline bool refused(const BodyPlan& plan, const std::string& reason) {
    const auto model = build_planar_model(plan, 1.0);
    return !model && model.error().message.find(reason) != std::string::npos;
}

}  // namespace cambrian::test
