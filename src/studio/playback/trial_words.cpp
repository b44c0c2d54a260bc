#include "studio/playback/trial_words.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

std::string drawn_side(const Trial& trial) {
    const double center = trial.scene().center_of_mass().x();
    if (const FixedBox* wall = trial.wall())
        return wall->center.x() < center ? ", wall on the left" : ", wall on the right";
    const LightSource& light = trial.surroundings().source();
    if (!light.is_on() || !light.moves() || trial.settling()) return {};
    return light.place().x() < center ? ", light on the left" : ", light on the right";
}

}  // namespace

std::string trial_words(const Playback& playback) {
    const int trials = playback.exhibit().settings().world.trial.trials;
    if (trials < 2) return {};
    return fmt::format("trial {} of {}", playback.creature().trial_number() + 1, trials) +
           drawn_side(playback.trial());
}

}  // namespace cambrian
