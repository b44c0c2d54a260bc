#pragma once

#include <cstdint>
#include <string_view>

namespace cambrian {

// How an evaluation ended.
enum class Outcome : std::uint8_t {
    kCompleted,
    kStoppedEarly,  // pruned: what was to come could not matter
    kRejected,      // nothing to simulate: no movable joint, or no live control
    kDiverged,      // physics found no finite motion
    kCheated,       // a guard fired
    kOverBudget,    // computing the motion would take too long
    kInterrupted,   // somebody stopped it; says nothing about the creature
};

// Whether there is no motion that can be judged, by the creature's own doing.
bool is_invalid(Outcome outcome);

std::string_view outcome_name(Outcome outcome);  // "completed", "stopped-early"...

}  // namespace cambrian
