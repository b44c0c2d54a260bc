#pragma once

#include "breeding/mutation_kind.h"
#include "evolution/individual/behavior.h"
#include "evolution/individual/parent_link.h"
#include "genome/genome.h"
#include "simulator/audit.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace cambrian {

// The result of the same trial computed with finer settings (finer_settings()).
struct FinerResult {
    Outcome outcome = Outcome::kCompleted;
    double score = 0.0;
    AuditVerdict verdict = AuditVerdict::kClean;

    friend bool operator==(const FinerResult&, const FinerResult&) = default;
};

struct EvaluationResult {
    // That of the finer trial if the first one was suspect; see `scores`. The least of the goal
    // (GoalKind::least_score) if a trial failed, and the score of the beginning if it was stopped.
    double fitness = 0.0;
    Outcome outcome = Outcome::kCompleted;
    std::uint64_t digest = 0;     // digest of the motion, to check replays
    std::uint64_t phenotype = 0;  // phenotype_hash() of the creature that was evaluated
    std::uint64_t plan = 0;       // body_plan_hash() of that creature
    double body_length = 0.0;     // m
    double mass = 0.0;            // kg
    int parts = 0;
    int neurons = 0;             // connected neurons
    Behavior behavior;           // zero unless simulated
    double computed_time = 0.0;  // s simulated in all its trials
    std::uint64_t work = 0;      // approximate number of evaluations of the accelerations
    bool terminable = false;     // its trial was terminated early, or could have been
    // Scores in the unchanged world and in those of the confirmation (confirmation.h). Their median
    // is the fitness. Empty without confirmation.
    std::vector<double> scores;
    std::string reason;                           // why it failed, in words
    AuditVerdict verdict = AuditVerdict::kClean;  // of the trial with the settings' step
    SceneAudit audit;                             // of the same trial
    std::optional<FinerResult> finer;             // for suspect trials and for saved champions
};

// A creature of one generation: its genotype, origin and result. It is immutable once evaluated,
// and shared between generations, snapshots and files.
struct Individual {
    std::uint64_t uid = 0;   // hash of (seed, generation of birth, child index)
    std::uint32_t born = 0;  // generation of birth
    // Generation in which its line of descent last changed its body; see differing_body_genes().
    std::uint32_t body_born = 0;
    std::uint64_t line = 0;  // uid of its founder along the line of mothers
    GenomePtr genome;
    std::uint64_t genome_hash = 0;
    std::array<std::uint64_t, 2> parents = {0, 0};  // uids; 0 for none
    ParentLink mother;   // the first parent as it was evaluated, if known
    std::string method;  // breeding method, or "random", "imported"
    std::vector<MutationRecord> mutations;
    std::uint64_t expected_work = 0;  // the larger of its parents' work; 0 if unknown
    bool evaluated = false;
    EvaluationResult result;
};

using IndividualPtr = std::shared_ptr<const Individual>;

// Returns the score of the first trial in the unchanged world, which a replay reproduces.
double unconfirmed_score(const EvaluationResult& result);

// Returns the same creature without its evaluation.
IndividualPtr without_score(const Individual& individual);

// Returns whether the creature has no valid motion. It ranks last.
bool disqualified(const Individual& individual);

// Returns whether a is fitter than b. Whoever came further in its trial is (shortfall()), whatever
// the scores are; of two that came equally far, the one with the higher score is.
bool fitter(const EvaluationResult& a, const EvaluationResult& b);

// Returns the creatures at the head of a ranking that came as far as its first: those that
// completed their trials or, if there are none, those that came nearest.
std::span<const IndividualPtr> furthest(std::span<const IndividualPtr> ranked);

// Returns whether a ranks before b: the fitter first, then fewer nodes and neurons, then older uid.
// The order is total and reproducible (evolution/README.md 1).
bool better(const Individual& a, const Individual& b);

}  // namespace cambrian
