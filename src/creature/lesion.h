#pragma once

// Lesions: what a grown body can be deprived of, one thing at a time, to see what it does for the
// creature. They change the phenotype; no gene knows them.

#include "creature/phenotype.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

enum class LesionKind : std::uint8_t {
    kLimpPart,      // no muscle from the part outwards has any strength; their mass stays
    kLostPart,      // the part is gone, and all beyond it
    kLockedJoint,   // the part is rigidly fixed to its parent
    kSilentNeuron,  // whoever hears the neuron hears 0
    kCutLink,       // a neuron's input, an effector or an organ hears 0
    kHeldSensor,    // the sensor reads a constant; 0 is silence
    kStillOrgan,    // the organ hears 0
};
inline constexpr int kLesionKindCount = 7;

// In the order of LesionKind, for files: "limp-part".
std::string_view lesion_id(LesionKind kind);

struct Lesion {
    LesionKind kind = LesionKind::kLimpPart;
    // Index of the part, neuron, sensor or organ; of a link, that of the neuron that reads it, or
    // the number of neurons plus the index of the output.
    std::uint32_t index = 0;
    std::uint8_t input = 0;  // of the neuron that reads a link
    double constant = 0.0;   // that a held sensor reads, in its own unit

    friend bool operator==(const Lesion&, const Lesion&) = default;
};

// Returns each thing that the creature can lose, parts first. Sensors are silent; constant links
// and neurons that nothing hears are left out.
std::vector<Lesion> lesions_of(const Phenotype& phenotype);

// Inflicts lesions, whose indices are those of the intact creature.
void inflict(std::span<const Lesion> lesions, Phenotype& phenotype);

// Returns the part that has what is lost; -1 for the central brain.
int part_of(const Lesion& lesion, const Phenotype& intact);

// Example: "joint of part 2 locked".
std::string words_of(const Lesion& lesion, const Phenotype& intact, const Kinds& kinds);
// Example: "joint of part 2 locked and neuron 3 silent".
std::string words_of(std::span<const Lesion> lesions, const Phenotype& intact, const Kinds& kinds);

}  // namespace cambrian
