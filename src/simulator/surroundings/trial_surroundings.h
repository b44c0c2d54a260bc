#pragma once

// The surroundings of a creature in the world of a trial.

#include "simulator/surroundings/light_source.h"
#include "world/environment.h"
#include "world/surroundings.h"

namespace cambrian {

class TrialSurroundings final : public Surroundings {
public:
    TrialSurroundings(const Environment& environment, const LightDraw& draw, double rest_length);

    void set_environment(const Environment& environment);

    Vec3 up() const override { return up_; }
    Light light(const Vec3& point) const override { return source_.at(point); }

    const LightSource& source() const { return source_; }
    LightSource& source() { return source_; }

private:
    void find_up(const Environment& environment);

    Vec3 up_ = Vec3::Zero();
    LightSource source_;
};

}  // namespace cambrian
