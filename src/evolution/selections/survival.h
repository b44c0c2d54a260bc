#pragma once

// Parts of several selection methods: survivors, and the places that remain for offspring.

#include "evolution/selections/selection.h"

#include <cstddef>
#include <span>
#include <vector>

namespace cambrian {

// The first `wanted` of the ranking, at most max_clones of one phenotype among them.
std::vector<std::size_t> first_of_ranking(std::span<const IndividualPtr> ranked, std::size_t wanted,
                                          int max_clones);

// How many survive truncation: the settings' share of the population, at least one.
std::size_t truncated_size(const PopulationSettings& population);

// The survivors of truncation. The settings limit the survivors of one founder's line and of one
// body plan. If too few others have a score, the limit of plans is lifted first, then that of
// lines.
std::vector<std::size_t> truncated(std::span<const IndividualPtr> ranked,
                                   const ExperimentSettings& settings);

// SelectionKind::survival of methods whose survivors are truncated().
SurvivalRule best_share(const SelectionSettings& settings);

// Share of the worst survivor's score that a creature must reach to survive; a trial that cannot
// may end early. It is 1 if creatures below the worst survivor have no effect, less if that is only
// likely (with limits of lines and plans), and 0 if the least fit may matter.
double termination_share(const SelectionKind& kind, const SelectionSettings& settings);

// Creatures of the ranking that were not disqualified; all of it if there are none. They are the
// first of the ranking.
std::span<const IndividualPtr> qualified(std::span<const IndividualPtr> ranked);

// The numbers of offspring and of random immigrants among `places`.
struct Places {
    std::size_t offspring = 0;
    std::size_t newcomers = 0;
};
Places share_places(std::size_t places, const ExperimentSettings& settings);

// Survivors and their offspring make one population; first parents by universal sampling of the
// weights, one weight an individual of the ranking.
SelectionResult breed_by_weight(std::vector<std::size_t> survivors, std::vector<double> weights,
                                const ExperimentSettings& settings, RandomStream& stream);

// Does the same for methods in which all survivors compete with a full population of offspring.
SelectionResult breed_whole_batch(std::vector<std::size_t> survivors, std::vector<double> weights,
                                  const ExperimentSettings& settings, RandomStream& stream);

}  // namespace cambrian
