#pragma once

// A few built-in trials, the digests of whose results tell whether two builds on two machines
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

// Every goal with the default integrator and with the accurate one, for creatures with joints of
// every kind; takes 0.2 s.
std::vector<ProofTrial> proof_trials(const EvolutionKinds& kinds);

// One number for all of them.
std::uint64_t proof_of(std::span<const ProofTrial> trials);

// Names of the expected trials that `found` has otherwise or not at all: "walking, x; jumping, y".
std::string differing_trials(std::span<const ProofTrial> expected,
                             std::span<const ProofTrial> found);

}  // namespace cambrian
