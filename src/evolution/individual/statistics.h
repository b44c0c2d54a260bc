#pragma once

#include "evolution/individual/individual.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace cambrian {

// The children born in a founder's line in one generation.
struct LineBirths {
    std::uint64_t line = 0;  // uid of the founder
    int births = 0;

    friend bool operator==(const LineBirths&, const LineBirths&) = default;
};

void put_most_first(std::vector<LineBirths>& births);

// The statistics of one evaluated generation, for plots and reports.
struct GenerationStatistics {
    std::uint32_t generation = 0;
    int size = 0;
    int evaluations = 0;    // different trials that were run, confirmations included
    int confirmations = 0;  // trials in slightly different worlds that confirm scores
    // Of those that completed their trials or, if there are none, of those that came furthest.
    double best = 0.0;         // fitness
    double best_lowest = 0.0;  // lowest score of the best creature in all its worlds
    double best_highest = 0.0;
    double upper = 0.0;  // 90th percentile
    double median = 0.0;
    double lower = 0.0;  // 10th percentile
    double mean = 0.0;
    double invalid_share = 0.0;  // share of creatures that diverged or were disqualified
    double mean_parts = 0.0;
    double mean_neurons = 0.0;
    int distinct_genomes = 0;
    int lines = 0;                   // founders from whom survivors descend along mothers
    int plans = 0;                   // different body plans among the survivors
    std::vector<LineBirths> births;  // of lines with births, sorted by put_most_first()
    // Trials that were not run, or not to the end (evolution/README.md 4).
    int rejected = 0;                   // P1: no joint can move, or nothing drives it
    int reused = 0;                     // P2: the phenotype already had a score
    int rested = 0;                     // P4: the creature came to rest
    int given_up = 0;                   // P5: it could not survive any more
    bool giving_up_distrusted = false;  // P5 is off because it proved unreliable
    double time_saved = 0;              // share of the trials' time that was not simulated
    int filled_cells = 0;               // cells filled of the map that the settings choose
    double terrain_level = 1.0;         // of the settings; not stored with the rest
    double quality = 0.0;               // QD-score: sum of the best fitness of each filled cell
    // The number of generations since the best last rose by 1 %, and its fitness then.
    int generations_without_progress = 0;
    double progress_mark = 0.0;
};

// `ranked` is sorted best first.
GenerationStatistics summarize(std::span<const IndividualPtr> ranked, std::uint32_t generation,
                               int evaluations);

// Counts founder lines and body plans of the survivors (indices into the ranking), and births per
// line.
void count_lines(GenerationStatistics& statistics, std::span<const IndividualPtr> ranked,
                 std::span<const std::size_t> survivors);

// Counts the savings. `results` are those of the trials run, `reused` the scores that needed no
// trial, and `full_time` the full duration of a creature's trials, in s.
void count_savings(GenerationStatistics& statistics,
                   std::span<const std::optional<EvaluationResult>> results, int reused,
                   double full_time);

// Continues the count of generations without progress from the last generation.
void continue_progress(GenerationStatistics& statistics, const GenerationStatistics& before);

// Returns whether the best has not risen by 1 % in 15 generations (evolution/README.md 3).
bool stagnant(const GenerationStatistics& statistics);

}  // namespace cambrian
