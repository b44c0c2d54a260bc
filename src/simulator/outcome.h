#pragma once

#include <cstdint>
#include <string_view>

namespace cambrian {

// How the evaluation of a creature ended.
enum class Outcome : std::uint8_t {
    kCompleted,
    kStoppedEarly,  // terminated because the rest could not matter
    kRejected,      // not simulated: no movable joint, or no connected control
    kDiverged,      // physics found no finite motion
    kDisqualified,  // a limit of the trial was exceeded (simulator/README.md 2)
    kOverBudget,    // computing the motion would take too long
    kInterrupted,   // stopped from outside; not caused by the creature
};

// Returns how far a creature came, from 0 for a completed trial to 3 for a motion that is invalid.
// Scores compare only creatures that came equally far; whoever came less far ranks below.
int shortfall(Outcome outcome);

// Returns whether the creature itself is the reason why there is no valid motion.
bool is_invalid(Outcome outcome);

std::string_view outcome_name(Outcome outcome);  // "completed", "stopped-early"...

}  // namespace cambrian
