#pragma once

// A few built-in trials. The digests of their results tell whether two builds on two machines
// compute the same bits.

#include "evolution/kinds/evolution_kinds.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cambrian {

struct ProofTrial {
    std::string name;  // "walking, bogacki-shampine"
    std::uint64_t digest = 0;

    friend bool operator==(const ProofTrial&, const ProofTrial&) = default;
};

// Runs every goal with the default and with the most accurate integrator, on creatures with joints,
// senses and organs of every kind; takes 0.2 s.
std::vector<ProofTrial> proof_trials(const EvolutionKinds& kinds);

// Returns one digest of all trials.
std::uint64_t proof_of(std::span<const ProofTrial> trials);

// Returns the names of the expected trials that are missing in `found` or differ: "walking, x;
// jumping, y".
std::string differing_trials(std::span<const ProofTrial> expected,
                             std::span<const ProofTrial> found);

}  // namespace cambrian
