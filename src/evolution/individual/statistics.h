#pragma once

#include "evolution/individual/individual.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace cambrian {

// Children that a founder's line had in a generation.
struct LineBirths {
    std::uint64_t line = 0;  // uid of the founder
    int births = 0;

    friend bool operator==(const LineBirths&, const LineBirths&) = default;
};

void put_most_first(std::vector<LineBirths>& births);

// What is plotted and printed of one evaluated generation.
struct GenerationStatistics {
    std::uint32_t generation = 0;
    int size = 0;
    int evaluations = 0;       // distinct trials run for it, those that confirm included
    int confirmations = 0;     // of those, trials in slightly different worlds, to confirm scores
    double best = 0.0;         // fitness
    double best_lowest = 0.0;  // the best creature's scores in all worlds that it was tried in
    double best_highest = 0.0;
    double upper = 0.0;  // 90th percentile
    double median = 0.0;
    double lower = 0.0;  // 10th percentile
    double mean = 0.0;
    double invalid_share = 0.0;  // diverged or cheated
    double mean_parts = 0.0;
    double mean_neurons = 0.0;
    int distinct_genomes = 0;
    int lines = 0;                   // founders that survivors descend from, by mothers
    int plans = 0;                   // body plans of survivors
    std::vector<LineBirths> births;  // of the lines that had any, put_most_first()
    // Trials not run, or not to the end (evolution/README.md 4):
    int rejected = 0;                   // P1: nothing could move, or nothing drove it
    int reused = 0;                     // P2: the phenotype had a score already
    int rested = 0;                     // P4: had come to rest
    int given_up = 0;                   // P5: could not survive any more
    bool giving_up_distrusted = false;  // P5 has switched itself off
    double time_saved = 0;              // share of the trials' time that was not simulated
    int filled_cells = 0;               // of the map chosen in the settings
    double quality = 0.0;               // QD-score: sum of the best fitness of each filled cell
    // Generations since the best last rose by 1 %, and the best as it was then.
    int generations_without_progress = 0;
    double progress_mark = 0.0;
};

// ranked: best first.
GenerationStatistics summarize(std::span<const IndividualPtr> ranked, std::uint32_t generation,
                               int evaluations);

// Counts founder lines and body plans of the survivors (indices into the ranking) and births by
// line.
void count_lines(GenerationStatistics& statistics, std::span<const IndividualPtr> ranked,
                 std::span<const std::size_t> survivors);

// Counts what was saved: results of the trials run, scores that needed none, and the time (s) each
// creature's trials take in full.
void count_savings(GenerationStatistics& statistics,
                   std::span<const std::optional<EvaluationResult>> results, int reused,
                   double full_time);

// Continues the count of generations without progress from the generation before.
void continue_progress(GenerationStatistics& statistics, const GenerationStatistics& before);

// The best has not risen by 1 % in 15 generations (evolution/README.md 3).
bool stagnant(const GenerationStatistics& statistics);

}  // namespace cambrian
