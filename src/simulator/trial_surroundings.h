#pragma once

// The surroundings of a creature in the world of a trial.

#include "world/environment.h"
#include "world/surroundings.h"

namespace cambrian {

class TrialSurroundings final : public Surroundings {
public:
    explicit TrialSurroundings(const Environment& environment) { set_environment(environment); }

    void set_environment(const Environment& environment);

    Vec3 up() const override { return up_; }

private:
    Vec3 up_ = Vec3::Zero();
};

}  // namespace cambrian
