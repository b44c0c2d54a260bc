#include "simulator/trial_surroundings.h"

#include "math/angle.h"

namespace cambrian {

void TrialSurroundings::set_environment(const Environment& environment) {
    const SineCosine pull = sine_cosine_of_degrees(environment.gravity_direction);
    up_ = environment.gravity > 0.0 ? Vec3(-pull.cosine, -pull.sine, 0.0) : Vec3(Vec3::Zero());
}

}  // namespace cambrian
