#pragma once

// A rhythm that all joints of a body follow (sketch/README.md 3).

#include "core/result.h"
#include "sketch/body_sketch.h"

namespace cambrian {

struct Rhythm {
    double frequency = 1.0;  // Hz
    double swing = 0.6;      // rad either way
    double wave = 1.0;       // cycles from the first joint to the last

    friend bool operator==(const Rhythm&, const Rhythm&) = default;
};
inline constexpr double kLeastFrequency = 0.2;
inline constexpr double kMostFrequency = 3.0;
inline constexpr double kLeastRhythmSwing = 0.05;
inline constexpr double kMostRhythmSwing = 1.6;
inline constexpr double kMostWave = 1.0;  // either way

// Gives each node whose joint moves a sine and lets the joint follow it. Fails if no joint moves.
Result<Genome> with_rhythm(const BodySketch& sketch, const Rhythm& rhythm,
                           const SketchRules& rules);
// Returns the rhythm that all joints follow as with_rhythm() gives it, or nothing.
std::optional<Rhythm> rhythm_of(const BodySketch& sketch, const SketchRules& rules);

}  // namespace cambrian
