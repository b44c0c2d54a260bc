#pragma once

// Functions that several selection methods share: the choice of survivors, and the places that
// remain.

#include "evolution/selections/selection.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace cambrian {

// Returns all places of the ranking.
std::vector<std::size_t> everybody(std::span<const IndividualPtr> ranked);

// Returns the first `wanted` of the ranking, with at most max_clones of one phenotype.
std::vector<std::size_t> first_of_ranking(std::span<const IndividualPtr> ranked, std::size_t wanted,
                                          int max_clones);

// Returns how far each of some of the ranking leads the least fit of those of them that came as far
// as the first, from 0 for that one to 1 for the first; 1 for all of these if they are equal, and 0
// for those that came less far. `places` are ascending and not empty.
std::vector<double> leads(std::span<const IndividualPtr> ranked,
                          std::span<const std::size_t> places);

// Returns the number of survivors of truncation: the settings' share of the population, at least
// one.
std::size_t truncated_size(const PopulationSettings& population);

// Returns the survivors of truncation. The settings limit the survivors of one founder's line and
// of one body plan. If too few others completed their trials, the limit on plans is dropped first,
// then that on lines, and then those survive that did not complete theirs.
std::vector<std::size_t> truncated(std::span<const IndividualPtr> ranked,
                                   const ExperimentSettings& settings);

// Implements SelectionKind::survival for methods whose survivors are those of truncated().
SurvivalRule best_share(const SelectionSettings& settings);

// The largest numbers of survivors of truncated() that are of one founder's line and of one body
// plan, unless too few others completed their trials. Nothing means that there is no limit.
struct SurvivalLimits {
    std::optional<std::size_t> line = std::nullopt;
    std::optional<std::size_t> plan = std::nullopt;
};
SurvivalLimits survival_limits(const ExperimentSettings& settings);

// Returns whether creatures below the survivors have no effect, so that their trials may end early,
// and every creature has only one trial, whose end decides alone.
bool may_terminate_early(const SelectionKind& kind, const ExperimentSettings& settings);

// The numbers of offspring and of random immigrants among `places`.
struct Places {
    std::size_t offspring = 0;
    std::size_t immigrants = 0;
};
Places share_places(std::size_t places, const ExperimentSettings& settings);

// Returns survivors and offspring that make one population. First parents are drawn by universal
// sampling with one weight per individual of the ranking.
SelectionResult breed_by_weight(std::vector<std::size_t> survivors, std::vector<double> weights,
                                const ExperimentSettings& settings, RandomStream& stream);

// Does the same for methods in which the survivors compete with a full population of offspring.
SelectionResult breed_whole_batch(std::vector<std::size_t> survivors, std::vector<double> weights,
                                  const ExperimentSettings& settings, RandomStream& stream);

}  // namespace cambrian
