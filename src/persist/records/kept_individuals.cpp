#include "persist/records/kept_individuals.h"

#include "persist/records/experiment_schema.h"
#include "persist/records/mutation_text.h"
#include "persist/records/score_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>

namespace cambrian {
namespace {

constexpr std::size_t kWordColumns = 6;  // outcome, verdict, those of the finer trial, scores

Statement result_insertion(const Database& database) {
    return database.prepare(
        fmt::format("INSERT OR REPLACE INTO results VALUES (?, ?{})",
                    more_places(kWordColumns + kResultColumns.size() + kBehaviorColumns.size() +
                                kAuditColumns.size() + kLaterResultColumns.size())));
}

}  // namespace

KeptIndividuals::KeptIndividuals(const Database& database, const EvolutionKinds& kinds,
                                 Knowledge& known)
    : known_(known),
      packer_(kinds),
      insert_individual_(
          database.prepare(fmt::format("INSERT INTO individuals VALUES (?{})", more_places(16)))),
      insert_genotype_(database.prepare("INSERT INTO genotypes VALUES (?, ?, ?)")),
      insert_result_(result_insertion(database)),
      update_individual_(
          database.prepare("UPDATE individuals SET fitness = ?, outcome = ?, verdict = ?, "
                           "digest = ?, parts = ?, neurons = ? WHERE id = ?")),
      delete_genotype_(database.prepare("DELETE FROM genotypes WHERE individual = ?")),
      delete_result_(database.prepare("DELETE FROM results WHERE individual = ? AND judged = ?")) {}

void KeptIndividuals::remember(const IndividualPtr& individual, const RowRef& row, bool survivor) {
    known_[individual->uid] = {.individual = individual, .row = row, .genotype_held = survivor};
}

RowRef KeptIndividuals::row_of(const Individual& individual) const {
    const auto found = known_.find(individual.uid);
    CAMBRIAN_ASSERT(found != known_.end(), "only who was kept has a row");
    return found->second.row;
}

RowRef KeptIndividuals::keep(const IndividualPtr& individual, std::int64_t judged) {
    const auto found = known_.find(individual->uid);
    if (found == known_.end()) {
        hold_parents(*individual);
        return known_.emplace(individual->uid, insert(individual, judged)).first->second.row;
    }
    Entry& entry = found->second;
    entry.genotype_held = true;  // it survived a generation
    if (entry.individual != individual) update_score(entry, individual, judged);
    return entry.row;
}

void KeptIndividuals::hold_score(const IndividualPtr& individual) {
    const auto found = known_.find(individual->uid);
    if (found == known_.end()) return;
    found->second.genotype_held = true;
    if (found->second.individual == individual) found->second.score_held = true;
}

void KeptIndividuals::hold_parents(const Individual& individual) {
    for (const std::uint64_t parent : individual.parents) {
        const auto found = known_.find(parent);
        if (found != known_.end()) found->second.genotype_held = true;
    }
}

KeptIndividuals::Entry KeptIndividuals::insert(const IndividualPtr& individual,
                                               std::int64_t judged) {
    const Individual& one = *individual;
    const auto mother = known_.find(one.parents[0]);
    insert_individual_.bind(std::nullopt, one.uid, one.born, one.body_born, one.parents[0],
                            one.parents[1]);
    if (mother != known_.end()) {
        insert_individual_.bind_next(mother->second.row.individual);
    } else {
        insert_individual_.bind_next(std::nullopt);
    }
    insert_individual_.bind_next(one.method);
    insert_individual_.bind_next(mutations_text(one.mutations));
    insert_individual_.bind_next(one.genome_hash);
    insert_individual_.bind_next(one.result.fitness);
    insert_individual_.bind_next(outcome_name(one.result.outcome));
    insert_individual_.bind_next(verdict_name(one.result.verdict));
    insert_individual_.bind_next(one.result.digest);
    insert_individual_.bind_next(one.result.parts);
    insert_individual_.bind_next(one.result.neurons);
    insert_individual_.bind_next(one.line);
    insert_individual_.finish();

    const RowRef row{insert_individual_.inserted_row(), judged};
    const PackedGenotype genotype = packer_.pack(one);
    insert_genotype_.bind(row.individual, static_cast<std::int64_t>(genotype.size));
    insert_genotype_.bind_bytes(genotype.bytes);
    insert_genotype_.finish();
    insert_score(one, row);
    return {.individual = individual, .row = row};
}

void KeptIndividuals::insert_score(const Individual& individual, const RowRef& row) {
    const EvaluationResult& result = individual.result;
    insert_result_.bind(row.individual, row.judged, outcome_name(result.outcome),
                        verdict_name(result.verdict));
    if (result.finer) {
        insert_result_.bind_next(outcome_name(result.finer->outcome));
        insert_result_.bind_next(result.finer->score);
        insert_result_.bind_next(verdict_name(result.finer->verdict));
    } else {
        for (int column = 0; column < 3; ++column)
            insert_result_.bind_next(std::nullopt);
    }
    bind_columns<EvaluationResult>(insert_result_, kResultColumns, result);
    bind_columns<Behavior>(insert_result_, kBehaviorColumns, result.behavior);
    bind_columns<SceneAudit>(insert_result_, kAuditColumns, result.audit);
    bind_columns<EvaluationResult>(insert_result_, kLaterResultColumns, result);
    if (result.scores.empty()) {
        insert_result_.bind_next(std::nullopt);
    } else {
        insert_result_.bind_next(scores_text(result.scores));
    }
    insert_result_.finish();
}

// Writes the score of an individual that was evaluated again with other settings.
void KeptIndividuals::update_score(Entry& entry, const IndividualPtr& individual,
                                   std::int64_t judged) {
    if (!entry.score_held) delete_score(entry);
    entry.individual = individual;
    entry.row.judged = judged;
    entry.score_held = false;
    const EvaluationResult& result = individual->result;
    update_individual_.run(result.fitness, outcome_name(result.outcome),
                           verdict_name(result.verdict), result.digest, result.parts,
                           result.neurons, entry.row.individual);
    insert_score(*individual, entry.row);
}

void KeptIndividuals::delete_score(const Entry& entry) {
    delete_result_.run(entry.row.individual, entry.row.judged);
}

void KeptIndividuals::drop_others(std::span<const IndividualPtr> population) {
    std::map<std::uint64_t, Entry> living;
    for (const IndividualPtr& individual : population) {
        auto node = known_.extract(individual->uid);
        if (!node.empty()) living.insert(std::move(node));
    }
    for (const auto& [uid, entry] : known_) {
        if (!entry.genotype_held) delete_genotype_.run(entry.row.individual);
        if (!entry.score_held) delete_score(entry);
    }
    known_ = std::move(living);
}

}  // namespace cambrian
