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
#include <string>
#include <vector>

namespace cambrian {

// The same trial computed once more, finer (finer_settings).
struct FinerResult {
    Outcome outcome = Outcome::kCompleted;
    double score = 0.0;
    AuditVerdict verdict = AuditVerdict::kClean;

    friend bool operator==(const FinerResult&, const FinerResult&) = default;
};

struct EvaluationResult {
    double fitness = 0.0;  // of the finer trial if the first one was suspect; see scores
    Outcome outcome = Outcome::kCompleted;
    std::uint64_t digest = 0;     // of the motion, for replay checks
    std::uint64_t phenotype = 0;  // phenotype_hash() of what was judged
    std::uint64_t plan = 0;       // body_plan_hash() of the same
    double body_length = 0.0;     // m
    double mass = 0.0;            // kg
    int parts = 0;
    int neurons = 0;             // live ones
    Behavior behavior;           // zero unless simulated
    double computed_time = 0.0;  // s of all its trials that were simulated
    std::uint64_t work = 0;      // evaluations of accelerations, about
    bool hopeless = false;       // its trial was given up, or could have been
    // Scores in the unchanged world and in those of the confirmation; their median is the fitness.
    // Empty without confirmation (confirmation.h).
    std::vector<double> scores;
    std::string reason;                           // why it failed, for a person
    AuditVerdict verdict = AuditVerdict::kClean;  // of the trial, computed as the settings say
    SceneAudit audit;                             // of the same
    std::optional<FinerResult> finer;             // of suspects, and of champions to be saved
};

// A creature of one generation: its genotype, origin and result. It is immutable once evaluated,
// and shared between generations, snapshots and files.
struct Individual {
    std::uint64_t uid = 0;   // hash of (seed, generation born, child index)
    std::uint32_t born = 0;  // generation
    // Generation in which its line of descent last changed its body; see same_body().
    std::uint32_t body_born = 0;
    std::uint64_t line = 0;  // uid of the founder that it descends from by mothers
    GenomePtr genome;
    std::uint64_t genome_hash = 0;
    std::array<std::uint64_t, 2> parents = {0, 0};  // uids; 0 for none
    ParentLink mother;                              // the first parent as it was judged, if known
    std::string method;                             // breeding kind, or "random", "imported"
    std::vector<MutationRecord> mutations;
    std::uint64_t expected_work = 0;  // that of its parents; 0 if unknown
    bool evaluated = false;
    EvaluationResult result;
};

using IndividualPtr = std::shared_ptr<const Individual>;

// What the first trial came to, in the world as it is: the score that a replay gives.
double unconfirmed_score(const EvaluationResult& result);

// The same creature as if it had never been evaluated.
IndividualPtr without_score(const Individual& individual);

// Without a motion that can be judged: ranks last and never breeds while there are others.
bool disqualified(const Individual& individual);

// Whether two genomes agree in all genes of parts, edges and root; neurons and effectors may
// differ.
bool same_body(const Genome& a, const Genome& b);

// The order of merit: completed before failed, fitter first, then fewer nodes and neurons, then
// older uid; total and reproducible (evolution/README.md 1).
bool better(const Individual& a, const Individual& b);

}  // namespace cambrian
