#pragma once

// Chooses the candidates that are shown: none that cannot move, and as different from one another
// as possible (picking/README.md 1).

#include "evolution/individual/individual.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

namespace cambrian {

// Measures of a creature's appearance: parts, log mass, height / body length, mean joint frequency,
// distance / body length.
using GridDescriptor = std::array<double, 5>;

GridDescriptor describe_for_grid(const EvaluationResult& result);

// Returns the descriptors of all, with each measure scaled to 0..1 by its range. A measure in which
// all agree is 0.
std::vector<GridDescriptor> scaled_descriptors(std::span<const IndividualPtr> all);

// Reasons against showing a candidate, from the mildest to the gravest.
enum class CandidateGrade : std::uint8_t {
    kAlive,
    kStatic,    // never moved by a hundredth of its length
    kRejected,  // was not simulated, since it has no joint that moves or nothing drives one
    kTwin,      // has the genome of a creature shown, of a parent or of an earlier candidate
    kInvalid    // has no motion that can be evaluated
};

// Grades evaluated candidates. `taken` has the genome hashes of parents and of creatures shown in
// any case.
std::vector<CandidateGrade> grade_candidates(std::span<const IndividualPtr> candidates,
                                             std::set<std::uint64_t> taken);

// Chooses `count` evaluated candidates (all, if there are fewer), in order of choice. Each time it
// takes the candidate c with the greatest value of
//     (1 - w) d(c) / d_max + w r(c)
// Here w is the weight of fitness and d the distance to the nearest creature shown or chosen so
// far; d_max is the greatest d. r is the rank by better(), from 1 for the best to 0 for the worst.
// w = 0 is farthest-point choice (Gonzalez 1985), w = 1 takes the fittest. The first of several
// equal ones is taken. If no creature is shown yet, the fittest is first for every w.
std::vector<std::size_t> choose_diverse(std::span<const IndividualPtr> candidates,
                                        std::span<const IndividualPtr> shown, std::size_t count,
                                        double fitness_weight);

}  // namespace cambrian
