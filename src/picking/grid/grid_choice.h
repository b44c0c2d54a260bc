#pragma once

// Which candidates are shown: no dead ones, and as different from one another as can be
// (picking/README.md 1).

#include "evolution/individual/individual.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

namespace cambrian {

// What a creature looks like to a person: parts, log mass, height / body length, mean joint
// frequency, distance / body length.
using GridDescriptor = std::array<double, 5>;

GridDescriptor describe_for_grid(const EvaluationResult& result);

// Descriptors of all, each measure scaled by their range to 0..1; one they agree in is 0.
std::vector<GridDescriptor> scaled_descriptors(std::span<const IndividualPtr> all);

// What speaks against showing a candidate, least bad first.
enum class CandidateGrade : std::uint8_t {
    kAlive,
    kStatic,  // cannot move, or never moved by a hundredth of its length
    kTwin,    // has the genome of a creature shown, of a parent or of an earlier candidate
    kInvalid  // has no motion that can be judged
};

// Grades of evaluated candidates; taken: genome hashes of parents and of what is shown anyway.
std::vector<CandidateGrade> grade_candidates(std::span<const IndividualPtr> candidates,
                                             std::set<std::uint64_t> taken);

// Chooses `count` evaluated candidates (all, if there are fewer), in order of choice. Each time the
// candidate c with the greatest
//     (1 - w) d(c) / d_max + w r(c)
// is taken: w is the weight of fitness, d the distance to the nearest creature shown or chosen so
// far, d_max the greatest d, r the rank by better() from 1 for the best to 0 for the worst.
// w = 0 is farthest-point choice (Gonzalez 1985), w = 1 takes the fittest. The first of equals is
// taken; where nothing is shown yet, the fittest is first whatever the weight.
std::vector<std::size_t> choose_diverse(std::span<const IndividualPtr> candidates,
                                        std::span<const IndividualPtr> shown, std::size_t count,
                                        double fitness_weight);

}  // namespace cambrian
