#include "persist/records/individual_reader.h"

#include "core/text/shown_text.h"
#include "evolution/evaluation/evaluation.h"
#include "persist/creature/creature_format.h"
#include "persist/records/experiment_schema.h"
#include "persist/records/mutation_text.h"
#include "persist/records/score_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cambrian {
namespace {

constexpr std::size_t kLongestScores = 10'000;  // bytes

template <class Choice>
Choice choice_of(std::string_view name, const std::vector<std::string>& names) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) throw DatabaseError(in_quotes(name) + " is no outcome");
    return static_cast<Choice>(found - names.begin());
}

Outcome outcome_of(std::string_view name) {
    return choice_of<Outcome>(name, creature_format::kOutcomes);
}
AuditVerdict verdict_of(std::string_view name) {
    return choice_of<AuditVerdict>(name, creature_format::kVerdicts);
}

std::vector<double> scores_of(std::string_view text) {
    std::optional<std::vector<double>> scores = parse_scores(text);
    if (!scores) throw DatabaseError("its scores are no numbers");
    return *std::move(scores);
}

void check_finite(const EvaluationResult& result) {
    for (const auto& column : kBehaviorColumns) {
        const auto* field = std::get_if<double Behavior::*>(&column.field);
        if (field != nullptr && !std::isfinite(result.behavior.*(*field)))
            throw DatabaseError(std::string(column.name) + " is not a number");
    }
    if (std::isnan(result.fitness)) throw DatabaseError("fitness is not a number");
}

}  // namespace

IndividualReader::IndividualReader(const Database& database, const EvolutionKinds& kinds)
    : kinds_(kinds),
      genotypes_(kinds),
      select_individual_(
          database.prepare("SELECT uid, born, body_born, parent1, parent2, mother, method, "
                           "mutations, genome_hash, fitness, outcome, verdict, digest, parts, "
                           "neurons, line FROM individuals WHERE id = ?")),
      select_genotype_(
          database.prepare("SELECT size, document FROM genotypes WHERE individual = ?")),
      select_result_(database.prepare(fmt::format(
          "SELECT outcome, verdict, finer_outcome, finer_fitness, finer_verdict, {}, {}, {}, {}, "
          "scores FROM results WHERE individual = ? AND judged = ?",
          column_names<EvaluationResult>(kResultColumns), column_names<Behavior>(kBehaviorColumns),
          column_names<SceneAudit>(kAuditColumns),
          column_names<EvaluationResult>(kLaterResultColumns)))) {}

IndividualPtr IndividualReader::read(const RowRef& row, const ExperimentSettings& settings) {
    IndividualPtr& place = individuals_[{row.individual, row.judged}];
    if (place) return place;
    auto [individual, mother] = read_row(row.individual);
    individual.result = read_result(row);
    individual.genome = read_genome(row.individual, individual.genome_hash);
    if (!individual.genome) throw DatabaseError("its genotype is missing");
    // Files older than version 3 do not have the body plan.
    if (individual.result.plan == 0)
        individual.result.plan = hashes_of(*individual.genome, settings, kinds_).plan;
    if (mother != 0) individual.mother = ParentLink(ancestor(mother, row.individual));
    place = std::make_shared<const Individual>(std::move(individual));
    return place;
}

IndividualReader::Row IndividualReader::read_row(std::int64_t id) {
    Statement& row = select_individual_;
    row.bind(id);
    if (!row.step()) throw DatabaseError(fmt::format("individual {} is missing", id));
    Individual one;
    one.uid = static_cast<std::uint64_t>(row.integer(0));
    read_column(row, 1, one.born);
    read_column(row, 2, one.body_born);
    read_column(row, 3, one.parents[0]);
    read_column(row, 4, one.parents[1]);
    const std::int64_t mother = row.is_null(5) ? 0 : row.integer(5);
    one.method = row.word(6);
    if (!row.is_null(7)) {
        auto mutations = parse_mutations(row.text(7, kLongestMutations));
        if (!mutations) throw DatabaseError(mutations.error().message);
        one.mutations = std::move(*mutations);
    }
    read_column(row, 8, one.genome_hash);
    one.evaluated = true;
    one.result.fitness = row.real(9);
    one.result.outcome = outcome_of(row.text(10));
    one.result.verdict = verdict_of(row.text(11));
    read_column(row, 12, one.result.digest);
    read_column(row, 13, one.result.parts);
    read_column(row, 14, one.result.neurons);
    read_column(row, 15, one.line);
    return {std::move(one), mother};
}

GenomePtr IndividualReader::read_genome(std::int64_t id, std::uint64_t hash) {
    const auto known = genomes_.find(id);
    if (known != genomes_.end()) return known->second;
    select_genotype_.bind(id);
    if (!select_genotype_.step()) return nullptr;
    Result<GenomePtr> genome =
        genotypes_.read(select_genotype_.bytes(1), select_genotype_.integer(0));
    if (!genome) throw DatabaseError(genome.error().message);
    if (genome_hash(**genome) != hash) throw DatabaseError("its genotype is another's");
    genomes_.emplace(id, *genome);
    return *genome;
}

EvaluationResult IndividualReader::read_result(const RowRef& row) {
    Statement& found = select_result_;
    found.bind(row.individual, row.judged);
    if (!found.step()) throw DatabaseError("its score is missing");
    EvaluationResult result;
    result.outcome = outcome_of(found.text(0));
    result.verdict = verdict_of(found.text(1));
    if (!found.is_null(2))
        result.finer =
            FinerResult{outcome_of(found.text(2)), found.real(3), verdict_of(found.text(4))};
    int next = read_columns<EvaluationResult>(found, 5, kResultColumns, result);
    next = read_columns<Behavior>(found, next, kBehaviorColumns, result.behavior);
    next = read_columns<SceneAudit>(found, next, kAuditColumns, result.audit);
    next = read_columns<EvaluationResult>(found, next, kLaterResultColumns, result);
    if (!found.is_null(next)) result.scores = scores_of(found.text(next, kLongestScores));
    check_finite(result);
    return result;
}

// Reads the known line of mothers. A mother has a lower row than her child.
IndividualPtr IndividualReader::ancestor(std::int64_t id, std::int64_t child) {
    std::vector<std::pair<std::int64_t, Individual>> line;
    IndividualPtr nearest;
    while (id != 0) {
        if (id >= child) throw DatabaseError("it is older than its mother");
        const auto known = ancestors_.find(id);
        if (known != ancestors_.end()) {
            nearest = known->second;
            break;
        }
        auto [individual, mother] = read_row(id);
        individual.genome = read_genome(id, individual.genome_hash);
        if (!individual.genome) break;
        line.emplace_back(id, std::move(individual));
        child = id;
        id = mother;
    }
    for (auto one = line.rbegin(); one != line.rend(); ++one) {
        if (nearest) one->second.mother = ParentLink(nearest);
        nearest = std::make_shared<const Individual>(std::move(one->second));
        ancestors_.emplace(one->first, nearest);
    }
    return nearest;
}

}  // namespace cambrian
