#include "simulator/surroundings/trial_surroundings.h"

#include "math/angle.h"

namespace cambrian {

TrialSurroundings::TrialSurroundings(const Environment& environment, const LightDraw& draw,
                                     double rest_length)
    : source_(environment, draw, rest_length) {
    find_up(environment);
}

void TrialSurroundings::set_environment(const Environment& environment) {
    find_up(environment);
    source_.set_environment(environment);
}

void TrialSurroundings::find_up(const Environment& environment) {
    const SineCosine pull = sine_cosine_of_degrees(environment.gravity_direction);
    up_ = environment.gravity > 0.0 ? Vec3(-pull.cosine, -pull.sine, 0.0) : Vec3(Vec3::Zero());
}

}  // namespace cambrian
