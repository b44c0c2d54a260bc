#pragma once

#include "studio/playback/playback.h"

#include <string>

namespace cambrian {

// Returns which of the creature's trials is displayed, and what chance drew for it: "trial 2 of 4,
// wall on the left". Empty if there is only one.
std::string trial_words(const Playback& playback);

}  // namespace cambrian
