#include "evolution/individual/statistics.h"

#include "core/assert.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace cambrian {
namespace {

constexpr double kProgress = 0.01;  // relative rise of the best fitness that counts as progress
constexpr int kPatience = 15;       // generations
constexpr double kTimeSlack = 0.1;  // s; smaller differences come from rounding to ticks

// Returns the fitness at a share of the ranking, from 0 for the worst to 1 for the best.
double quantile(std::span<const IndividualPtr> ranked, double share) {
    const double position = (1.0 - share) * static_cast<double>(ranked.size() - 1);
    return ranked[static_cast<std::size_t>(std::lround(position))]->result.fitness;
}

}  // namespace

GenerationStatistics summarize(std::span<const IndividualPtr> ranked, std::uint32_t generation,
                               int evaluations) {
    CAMBRIAN_ASSERT(!ranked.empty(), "a generation has creatures");
    GenerationStatistics summary;
    summary.generation = generation;
    summary.size = static_cast<int>(ranked.size());
    summary.evaluations = evaluations;
    summary.best = ranked.front()->result.fitness;
    const std::vector<double>& scores = ranked.front()->result.scores;
    const auto range = std::minmax_element(scores.begin(), scores.end());
    summary.best_lowest = scores.empty() ? summary.best : *range.first;
    summary.best_highest = scores.empty() ? summary.best : *range.second;
    summary.progress_mark = summary.best;
    const std::span<const IndividualPtr> scored = furthest(ranked);
    summary.upper = quantile(scored, 0.9);
    summary.median = quantile(scored, 0.5);
    summary.lower = quantile(scored, 0.1);
    for (const IndividualPtr& individual : scored)
        summary.mean += individual->result.fitness / static_cast<double>(scored.size());
    const double count = static_cast<double>(ranked.size());
    std::set<std::uint64_t> hashes;
    for (const IndividualPtr& individual : ranked) {
        const EvaluationResult& result = individual->result;
        summary.invalid_share += (disqualified(*individual) ? 1.0 : 0.0) / count;
        summary.mean_parts += result.parts / count;
        summary.mean_neurons += result.neurons / count;
        hashes.insert(individual->genome_hash);
    }
    summary.distinct_genomes = static_cast<int>(hashes.size());
    return summary;
}

void count_lines(GenerationStatistics& statistics, std::span<const IndividualPtr> ranked,
                 std::span<const std::size_t> survivors) {
    std::set<std::uint64_t> lines;
    std::set<std::uint64_t> plans;
    for (const std::size_t survivor : survivors) {
        lines.insert(ranked[survivor]->line);
        plans.insert(ranked[survivor]->result.plan);
    }
    statistics.lines = static_cast<int>(lines.size());
    statistics.plans = static_cast<int>(plans.size());
    std::map<std::uint64_t, int> births;
    for (const IndividualPtr& individual : ranked) {
        if (individual->born == statistics.generation) ++births[individual->line];
    }
    statistics.births.clear();
    for (const auto& [line, count] : births)
        statistics.births.push_back({line, count});
    put_most_first(statistics.births);
}

void put_most_first(std::vector<LineBirths>& births) {
    std::sort(births.begin(), births.end(), [](const LineBirths& a, const LineBirths& b) {
        return a.births != b.births ? a.births > b.births : a.line < b.line;
    });
}

void count_savings(GenerationStatistics& statistics,
                   std::span<const std::optional<EvaluationResult>> results, int reused,
                   double full_time) {
    statistics.reused = reused;
    double computed = 0.0;
    for (const std::optional<EvaluationResult>& result : results) {
        computed += result->computed_time;
        statistics.rejected += result->outcome == Outcome::kRejected ? 1 : 0;
        statistics.given_up += result->outcome == Outcome::kStoppedEarly ? 1 : 0;
        const bool rested = result->outcome == Outcome::kCompleted &&
                            result->computed_time < full_time - kTimeSlack;
        statistics.rested += rested ? 1 : 0;
    }
    const double full = full_time * (static_cast<double>(results.size()) + reused);
    if (full > 0.0) statistics.time_saved = std::fmax(0.0, 1.0 - computed / full);
}

void continue_progress(GenerationStatistics& statistics, const GenerationStatistics& before) {
    const double needed = before.progress_mark + kProgress * std::fabs(before.progress_mark);
    if (statistics.best > before.progress_mark && statistics.best >= needed) return;
    statistics.progress_mark = before.progress_mark;
    statistics.generations_without_progress = before.generations_without_progress + 1;
}

bool stagnant(const GenerationStatistics& statistics) {
    return statistics.generations_without_progress >= kPatience;
}

}  // namespace cambrian
