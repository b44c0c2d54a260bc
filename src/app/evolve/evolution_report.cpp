#include "app/evolve/evolution_report.h"

#include "core/text/number_text.h"
#include "genome/creature_name.h"
#include "persist/json/json_text.h"
#include "persist/records/statistics_columns.h"
#include "persist/text/digest_text.h"
#include "persist/text/quoted_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <span>
#include <variant>

namespace cambrian {
namespace {

constexpr double kOverfitting =
    0.25;  // excess of the score in trials of evolution over the held-out score

// Formats with four decimals, so that columns align in all generations.
std::string fixed(double number) {
    return fmt::format("{:.4f}", number);
}

std::string right_aligned(std::string text, std::size_t width) {
    if (text.size() < width) text.insert(0, width - text.size(), ' ');
    return text;
}

// Returns remarks on a generation, for example that fitness stagnates.
std::string remarks(const GenerationStatistics& statistics) {
    std::string text;
    if (stagnant(statistics)) {
        text += fmt::format("   no progress for {} generations",
                            statistics.generations_without_progress);
    }
    if (statistics.giving_up_distrusted)
        text += "   early termination is off: an audited trial would have survived";
    return text;
}

std::string json_of(const MutationRecord& mutation) {
    return json_object({{"operator", quoted_text(mutation.operator_id)},
                        {"place", quoted_text(mutation.place)},
                        {"from", quoted_text(mutation.from)},
                        {"to", quoted_text(mutation.to)}});
}

std::string json_of_parents(const Individual& individual) {
    std::vector<std::string> parents;
    for (const std::uint64_t parent : individual.parents) {
        if (parent != 0) parents.push_back(quoted_text(hex_text(parent)));
    }
    return json_list(parents);
}

std::string json_of_mutations(const Individual& individual) {
    std::vector<std::string> mutations;
    mutations.reserve(individual.mutations.size());
    for (const MutationRecord& mutation : individual.mutations)
        mutations.push_back(json_of(mutation));
    return json_list(mutations);
}

// Returns the births per founder line: {"00f3a1b2c4d5e6f7": 12, ...}. The keys are the founders'
// uids.
std::string json_of_births(const GenerationStatistics& statistics) {
    JsonMembers lines;
    for (const LineBirths& line : statistics.births)
        lines.push_back({hex_text(line.line), std::to_string(line.births)});
    return json_object(lines);
}

std::string json_value(double number) {
    return real_text(number);
}
std::string json_value(bool truth) {
    return json_truth(truth);
}
std::string json_value(const std::string& text) {
    return quoted_text(text);
}
template <class Whole>
std::string json_value(Whole number) {
    return std::to_string(number);
}

void add_members(JsonMembers& members, const GenerationStatistics& row,
                 std::span<const Column<GenerationStatistics>> columns) {
    for (const Column<GenerationStatistics>& column : columns) {
        const auto value = [&row](auto field) { return json_value(row.*field); };
        members.push_back({column.name, std::visit(value, column.field)});
    }
}

std::string json_of(const GenerationStatistics& statistics, const ReportedRun& run,
                    const std::string& cluster) {
    JsonMembers members = {{"seed", std::to_string(run.seed)}};
    add_members(members, statistics, kStatisticsColumns);
    add_members(members, statistics, kLaterStatisticsColumns);
    members.push_back({"births_by_line", json_of_births(statistics)});
    members.push_back({"unit", quoted_text(run.unit)});
    if (!cluster.empty()) members.push_back({"cluster", cluster});
    return json_object(members);
}

std::string json_of(const TerminationAudit& audit) {
    return json_object({{"finished", std::to_string(audit.finished)},
                        {"would_have_survived", std::to_string(audit.survived)}});
}

// Example: "0.93 BL/s, the median of 11 worlds (0.81 to 0.99)".
std::string confirmed_in_words(const EvaluationResult& result, const std::string& unit) {
    const auto range = std::minmax_element(result.scores.begin(), result.scores.end());
    return fmt::format("{} {}, the median of {} worlds ({} to {})", fixed(result.fitness), unit,
                       result.scores.size(), fixed(*range.first), fixed(*range.second));
}

// Example: "0.4100 points, in 8 trials that no generation used; overfitted: 0.7000 points
// in trials of its generation".
std::string held_out_in_words(double score, double trained, const std::string& unit) {
    std::string text =
        fmt::format("{} {}, in 8 trials that no generation used", fixed(score), unit);
    if (trained - score > kOverfitting)
        text +=
            fmt::format("; overfitted: {} {} in trials of its generation", fixed(trained), unit);
    return text;
}

std::string json_of_scores(const EvaluationResult& result) {
    std::vector<std::string> scores;
    for (const double score : result.scores)
        scores.push_back(real_text(score));
    return json_list(scores);
}

std::string json_of_path(const std::filesystem::path& path) {
    return path.empty() ? "null" : quoted_text(path.string());
}

}  // namespace

std::string origin_in_words(const Individual& individual) {
    std::string text = fmt::format("born in generation {}, {}", individual.born, individual.method);
    for (const MutationRecord& mutation : individual.mutations) {
        text += fmt::format("; {}: ", mutation.place);
        text += mutation.from.empty() ? mutation.to
                                      : fmt::format("{} to {}", mutation.from, mutation.to);
    }
    return text;
}

std::string generation_line(const GenerationStatistics& statistics, const ReportedRun& run,
                            const std::string& cluster) {
    if (run.json) return json_of(statistics, run, cluster);
    const std::string& unit = run.unit;
    const std::string number = std::to_string(statistics.generation);
    return fmt::format("generation {}   best {} {}   median {} {}{}", right_aligned(number, 4),
                       right_aligned(fixed(statistics.best), 8), unit,
                       right_aligned(fixed(statistics.median), 8), unit, remarks(statistics));
}

std::string final_line(const Evolution& evolution, const ReportedRun& run,
                       const ReportedChampion& reported, const RunOutputs& files,
                       std::string_view stopped_by) {
    const std::string& unit = run.unit;
    const Individual& champion = reported.individual;
    const std::vector<GenerationStatistics>& history = evolution.history();
    const TerminationAudit& audit = evolution.termination_audit();
    const bool gave_up = evolution.termination_audit().finished > 0;
    const GenerationStatistics& first = history.front();
    const GenerationStatistics& last = history.back();
    const bool interrupted = stopped_by == "interruption";
    if (run.json) {
        return json_object(
            {{"champion", json_of_path(files.champion)},
             {"experiment", json_of_path(files.experiment)},
             {"name", quoted_text(creature_name(*champion.genome))},
             {"uid", quoted_text(hex_text(champion.uid))},
             {"born", std::to_string(champion.born)},
             {"method", quoted_text(champion.method)},
             {"parents", json_of_parents(champion)},
             {"mutations", json_of_mutations(champion)},
             {"generations", std::to_string(history.size())},
             {"best_of_first", real_text(first.best)},
             {"best_of_last", real_text(last.best)},
             {"fitness", real_text(champion.result.fitness)},
             {"scores", json_of_scores(champion.result)},
             {"held_out", reported.held_out ? real_text(*reported.held_out) : "null"},
             {"audited", gave_up ? json_of(audit) : "null"},
             {"unit", quoted_text(unit)},
             {"stopped_by", quoted_text(stopped_by)},
             {"interrupted", json_truth(interrupted)}});
    }
    std::string text =
        fmt::format("{} of generation {}: {} {}, of generation {}: {} {}\nchampion: {} ",
                    interrupted ? "interrupted; best" : "best", first.generation, fixed(first.best),
                    unit, last.generation, fixed(last.best), unit, creature_name(*champion.genome));
    if (!files.champion.empty()) text += fmt::format("in {} ", files.champion.string());
    text += fmt::format("({})", origin_in_words(champion));
    if (!champion.result.scores.empty())
        text += "\nconfirmed: " + confirmed_in_words(champion.result, unit);
    if (reported.held_out)
        text +=
            "\nheld out: " + held_out_in_words(*reported.held_out, champion.result.fitness, unit);
    if (gave_up) {
        text += fmt::format("\nearly termination: {} audited, {} would have survived",
                            audit.finished, audit.survived);
    }
    if (!files.experiment.empty()) text += "\nexperiment: " + files.experiment.string();
    return text;
}

}  // namespace cambrian
